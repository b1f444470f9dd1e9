// Candidate effect: a stop that is met beyond a gap.
#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::Candidate bumpStop(const fit::Excitation& excitation) {
  fit::Candidate candidate{
      "bump_stop", "stop beyond a gap on one or both sides: a knee, error only beyond it", false, {}};
  candidate.terms_of_one = 4;  // a gap between two of these on each side; knees at many gaps are a curve without one
  for (const double side : {0.0, 1.0, -1.0}) {
    for (const double share : {0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
      const element::ParameterValues place = {{"gap", {share * excitation.largest_displacement}}, {"side", {side}}};
      candidate.terms.push_back(fit::additiveTerm("bump_stop", "stiffness", excitation.stiffness, place));
      element::ParameterValues of_rubber = place;
      of_rubber["exponent"] = {1.5};
      candidate.laws.push_back(fit::additiveTerm("bump_stop", "stiffness", excitation.stiffness, of_rubber));
    }
  }
  return candidate;
}

const CandidateEntry kBumpStopEntry(70, bumpStop);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
