// Candidate effect: viscous damping, linear or not, the same at any displacement or not.
#include "diagnosis/effect.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addViscousDamping(const fit::Excitation& excitation, fit::Candidate& candidate) {
  const double typical = 0.05 * excitation.stiffness / (2.0 * element::kPi * excitation.highest_frequency);
  candidate.terms = {fit::additiveTerm("dashpot", "damping", typical, {{"order", {2.0}}})};
  for (const double exponent : {0.5, 2.0}) {  // thins under shear; flows through an orifice
    candidate.terms.push_back(
        fit::additiveTerm("power_dashpot", "damping", typical,
                          {{"reference_rate", {excitation.highest_rate}}, {"exponent", {exponent}}}));
  }
  for (const double share : {0.3, 1.0}) {  // thins to a limit
    candidate.terms.push_back(
        fit::additiveTerm("thinning_dashpot", "damping", typical, {{"half_rate", {share * excitation.highest_rate}}}));
  }
  for (const double power : {1.0, 4.0}) {  // a gap that the fluid is squeezed through closes
    for (const double side : {1.0, -1.0}) {
      candidate.terms.push_back(fit::additiveTerm(
          "position_dashpot", "damping", typical,
          {{"reference_displacement", {excitation.largest_displacement}}, {"power", {power}}, {"side", {side}}}));
      candidate.terms.back().of_a_side = true;
    }
  }
}

const EffectEntry kViscousDamping({40, "viscous_damping", "dashpot: loss force grows with frequency", false,
                                   addViscousDamping});

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
