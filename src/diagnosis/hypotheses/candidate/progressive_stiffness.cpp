// Candidate effect: stiffening that is equal in tension and compression.
#include <cmath>

#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addProgressiveStiffness(const fit::Excitation& excitation, fit::Candidate& candidate) {
  const double z = excitation.largest_displacement;
  const double typical = 0.2 * excitation.stiffness;
  candidate.terms = {fit::additiveTerm("progressive_stiffness", "quadratic", typical / z),
                     fit::additiveTerm("progressive_stiffness", "cubic", typical / (z * z)),
                     fit::additiveTerm("progressive_stiffness", "quintic", typical / (z * z * z * z))};
  for (const double share : {0.3, 0.15}) {  // steep laws without a kink
    candidate.terms.push_back(fit::additiveTerm("progressive_stiffness", "exponential",
                                                typical * std::exp(-1.0 / share),
                                                {{"exponential_scale", {share * z}}}));
  }
}

const EffectEntry kProgressiveStiffness(
    {50, "progressive_stiffness",
     "stiffening that is equal in both directions: stiffness rises with amplitude, without additional loss", false,
     addProgressiveStiffness});

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
