// Candidate effect: relaxation that is slower than the motion.
#include <algorithm>

#include "diagnosis/effect.h"
#include "diagnosis/hypotheses/candidate/branches.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addCreep(const fit::Excitation& excitation, fit::Candidate& candidate) {
  // Creep begins within the relaxation times of the effect relaxation. The branches represent departures from its law.
  const double longest = longestRelaxationTime(excitation);
  constexpr double kBegins = 0.2;      // divided by the longest relaxation time
  constexpr double kBeyondLog = 10.0;  // divided by the duration of the longest log; logs do not determine a later end
  constexpr double kShortest = 1.2;    // divided by the longest relaxation time
  candidate.terms.push_back(
      fit::additiveTerm("creep", "stiffness_per_decade", 0.05 * excitation.stiffness,
                        {{"shortest_time", {kBegins * longest}},
                         {"longest_time", {kBeyondLog * std::max(longest, excitation.longest_duration)}}}));
  std::vector<double> frequencies;
  for (double time = kShortest * longest; time < 3.0 * excitation.longest_duration; time *= 2.5) {
    frequencies.push_back(1.0 / (2.0 * element::kPi * time));
  }
  addBranches(frequencies, 0.05 * excitation.stiffness, excitation, candidate);
}

const EffectEntry kCreep({30, "creep", "slow relaxation: force under a hold drifts with the logarithm of time", false,
                          addCreep, InSettledLoops::has_crept});

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
