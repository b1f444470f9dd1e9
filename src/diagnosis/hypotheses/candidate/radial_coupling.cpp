// Candidate effect: stiffening along the radius that the direction shares with another direction.
#include <cmath>

#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// Adds whole radial laws, for components whose configured law is linear. Also adds laws of what the radius alone
// contributes, for components whose laws are right along each direction by itself.
void addRadialCoupling(const fit::Excitation& excitation, fit::Candidate& candidate) {
  const double r = excitation.largest_radius;
  if (r == 0.0) {
    return;
  }
  const double typical = 0.2 * excitation.stiffness;
  for (const double alone : {1.0, 0.0}) {
    for (const auto& [key, power] : {std::pair("quadratic", 1), std::pair("cubic", 2), std::pair("quintic", 4)}) {
      candidate.terms.push_back(
          fit::additiveTerm("radial_stiffness", key, typical / std::pow(r, power), {{"alone", {alone}}}));
    }
  }
}

const EffectEntry kRadialCoupling({65, "radial_coupling",
                                   "stiffening with the radial displacement across an axis: the gap in one direction "
                                   "depends on the displacement in the other; only for components of six directions",
                                   false, addRadialCoupling});

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
