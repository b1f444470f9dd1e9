// Candidate effect: odd stiffening.
#include <cmath>

#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::Candidate progressiveStiffness(const fit::Excitation& excitation) {
  const double z = excitation.largest_displacement;
  const double typical = 0.2 * excitation.stiffness;
  fit::Candidate candidate{"progressive_stiffness",
                           "odd stiffening: stiffness rises with amplitude, no loss",
                           false,
                           {fit::additiveTerm("progressive_stiffness", "quadratic", typical / z),
                            fit::additiveTerm("progressive_stiffness", "cubic", typical / (z * z)),
                            fit::additiveTerm("progressive_stiffness", "quintic", typical / (z * z * z * z))}};
  for (const double share : {0.3, 0.15}) {  // steep, without a knee
    candidate.terms.push_back(fit::additiveTerm("progressive_stiffness", "exponential",
                                                typical * std::exp(-1.0 / share),
                                                {{"exponential_scale", {share * z}}}));
  }
  return candidate;
}

const CandidateEntry kProgressiveStiffnessEntry(50, progressiveStiffness);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
