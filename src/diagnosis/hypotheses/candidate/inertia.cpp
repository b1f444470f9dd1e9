// Candidate effect: mass that moves with the displacement.
#include "diagnosis/hypotheses/candidate/registry.h"
#include "fit/excitation.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::Candidate inertia(const fit::Excitation& excitation) {
  const double omega = 2.0 * element::kPi * excitation.highest_frequency;
  fit::BasisTerm mass = fit::additiveTerm("inertia", "mass", 0.05 * excitation.stiffness / (omega * omega),
                                          {{"bandwidth", {excitation.mass_bandwidth}}});
  mass.on_rig = true;
  mass.exact = fit::acceleration;
  fit::Candidate candidate{
      "inertia", "moving fixture: error of stiffness grows with frequency squared, in phase", true, {mass}};
  candidate.one_form = true;
  return candidate;
}

const CandidateEntry kInertiaEntry(120, inertia);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
