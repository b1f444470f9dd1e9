// Candidate effect: a contact that opens.
#include "diagnosis/hypotheses/candidate/registry.h"
#include "diagnosis/judge/containment.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// The share of its force that a spring as stiff as the logs loses where the contact is open: all of it at 1.
fit::BasisTerm contactTerm(const fit::Excitation& excitation, double side) {
  fit::BasisTerm term;
  term.at = [=, stiffness = excitation.stiffness](double share) {
    element::ElementDescription entry{"lift_off", {{"side", {side}}}};
    if (share < 1.0) {
      entry.values["slack_stiffness"] = {stiffness * (1.0 - share) / share};
    }
    return entry;
  };
  term.typical = 0.5;
  term.upper = 1.0;
  term.additive = false;
  return term;
}

// The sign of the force that a contact may carry in these logs; 0: they have much of both, so that none opens.
double sideOf(const fit::Excitation& excitation) {
  constexpr double kMost = 0.5;  // of the force of the other sign: what a zero, and what still holds, leave of it
  return -excitation.lowest_force < kMost * excitation.highest_force   ? 1.0
         : excitation.highest_force < -kMost * excitation.lowest_force ? -1.0
                                                                       : 0.0;
}

// A contact that something holds is a compliance of one side.
fit::Candidate liftOff(const fit::Excitation& excitation) {
  fit::Candidate candidate{
      "lift_off",
      "contact that carries one sign of force, as of a chevron, strap or spring that is not glued: "
      "slack on the way back, no force beyond",
      false,
      {}};
  const double side = sideOf(excitation);
  if (side != 0.0) {
    candidate.terms = {contactTerm(excitation, side)};
    candidate.contains = judge::containedIn(candidate.effect);
  }
  return candidate;
}

const CandidateEntry kLiftOffEntry(115, liftOff);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
