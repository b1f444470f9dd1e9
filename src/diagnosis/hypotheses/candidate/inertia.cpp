// Candidate effect: a mass that moves with the displacement.
#include "diagnosis/effect.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addInertia(const fit::Excitation& excitation, fit::Candidate& candidate) {
  const double omega = 2.0 * element::kPi * excitation.highest_frequency;
  fit::BasisTerm mass = fit::additiveTerm("inertia", "mass", 0.05 * excitation.stiffness / (omega * omega),
                                          {{"bandwidth", {excitation.mass_bandwidth}}});
  mass.on_rig = true;
  mass.exact = fit::acceleration;
  candidate.terms = {mass};
  candidate.one_form = true;
}

const EffectEntry kInertia({120, "inertia", "moving fixture: the error of the stiffness grows with frequency squared",
                            true, addInertia});

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
