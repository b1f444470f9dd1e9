// Constructs Maxwell branches.
#include "diagnosis/hypotheses/candidate/branches.h"

#include <algorithm>

namespace rubber_suspension::diagnosis::hypotheses::candidate {

double longestRelaxationTime(const fit::Excitation& excitation) {
  constexpr double kCycles = 30.0;
  constexpr double kOfLog = 0.1;
  const double slower_than_motion = std::min(kCycles / excitation.mean_frequency, kOfLog * excitation.longest_duration);
  return std::max(slower_than_motion, excitation.slowest_loop);
}

void addBranches(const std::vector<double>& frequencies, double typical, const fit::Excitation& excitation,
                 fit::Candidate& candidate) {
  for (const double frequency : frequencies) {
    candidate.terms.push_back(fit::additiveTerm("maxwell", "stiffness", typical, {{"break_frequency", {frequency}}}));
  }
  candidate.along = [frequencies, typical, largest = excitation.largest_displacement](const fit::Curve& curve) {
    std::vector<fit::BasisTerm> terms;
    for (const double frequency : frequencies) {
      terms.push_back(fit::additiveTerm("maxwell_along_curve", "stiffness", typical,
                                        {{"break_frequency", {frequency}},
                                         {"displacement", {largest}},
                                         {"growth", {curve.growth}},
                                         {"side", {curve.side}}}));
      terms.back().depends_on_place = true;
    }
    return terms;
  };
}

}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
