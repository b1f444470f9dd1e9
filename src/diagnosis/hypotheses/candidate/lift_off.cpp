// Candidate effect: a contact that opens.
#include <algorithm>

#include "diagnosis/effect.h"
#include "element/each.h"

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

void addLiftOff(const fit::Excitation& excitation, fit::Candidate& candidate) {
  const double side = sideOf(excitation);
  if (side != 0.0) {
    candidate.terms = {contactTerm(excitation, side)};
  }
}

// The side on which a contact is slack says as much as what holds it there, mostly nothing.
std::vector<HeadlineValue> whatHoldsIt(const Effect::Entries& contacts) {
  return element::each(contacts, [](const element::ElementDescription& entry) -> HeadlineValue {
    return {entry.value("side") > 0.0 ? "slack_stiffness_in_compression" : "slack_stiffness_in_tension", "N/m",
            valueOr(entry, "slack_stiffness", 0.0), false};
  });
}

// The sign of force that it carries.
std::vector<std::string> carried(const Effect::Entries& augmented) {
  const auto contact = std::find_if(augmented.begin(), augmented.end(),
                                    [](const element::ElementDescription& entry) { return entry.type == "lift_off"; });
  if (contact == augmented.end()) {
    return {};
  }
  return {contact->value("side") > 0.0 ? "carries tension alone" : "carries compression alone"};
}

// A contact that something holds is a compliance of one side.
Effect liftOff() {
  Effect effect{115, "lift_off",
                "contact that carries one sign of force, as of a chevron, strap or spring that is not glued: slack on "
                "the way back, no force beyond",
                false, addLiftOff};
  effect.contains = {"series_compliance"};
  effect.headline = whatHoldsIt;
  effect.headline_types = {effect.name};
  effect.facts = carried;
  return effect;
}

const EffectEntry kLiftOff(liftOff());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
