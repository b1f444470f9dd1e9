// Candidate effect: a contact that opens.
#include <algorithm>
#include <iterator>
#include <limits>

#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// Returns the term of a contact in series with a spring that has the stiffness of the logs. The scale is the fraction
// of the force of this spring that is lost while the contact is open; at 1, all of it is lost.
fit::BasisTerm contactTerm(const fit::Excitation& excitation, double side, double preload) {
  fit::BasisTerm term;
  term.at = [=, stiffness = excitation.stiffness](double share) {
    element::ElementDescription entry{"lift_off", {{"side", {side}}}};
    if (preload > 0.0) {
      entry.values["preload"] = {preload};
    }
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

// The extremes of the force, which indicate whether a contact opens.
struct Opening {
  double side;     // sign of the force that the contact can transmit
  double largest;  // largest magnitude of forces of the other sign [N]
  double share;    // `largest` divided by the largest force of the sign `side`
};

Opening openingOf(const fit::Excitation& excitation) {
  const double tension = std::max(0.0, excitation.highest_force);
  const double compression = std::max(0.0, -excitation.lowest_force);
  return compression < tension ? Opening{1.0, compression, compression / tension}
                               : Opening{-1.0, tension, tension / compression};
}

// Adds a contact without a preload and, if an offset does not explain the force of the other sign, contacts with a
// preload. The largest force of the other sign is the preload of a contact that transmits no force while open.
void addLiftOff(const fit::Excitation& excitation, fit::Candidate& candidate) {
  constexpr double kMost = 0.7;    // `share` above which the contact would be open for too little of the motion
  constexpr double kOfZero = 0.1;  // `share` that an offset of the force may cause
  const Opening opening = openingOf(excitation);
  if (!(opening.share < kMost)) {
    return;
  }
  candidate.terms = {contactTerm(excitation, opening.side, 0.0)};
  if (opening.share > kOfZero) {
    for (const double part : {0.5, 0.9, 1.0}) {
      candidate.terms.push_back(contactTerm(excitation, opening.side, part * opening.largest));
    }
    candidate.terms.back().start = 1.0;
  }
}

double leastPreload(const Effect::Entries& contacts) {
  double least = std::numeric_limits<double>::infinity();
  for (const element::ElementDescription& entry : contacts) {
    least = std::min(least, valueOr(entry, "preload", 0.0));
  }
  return least;
}

// Returns the stiffness that remains once all contacts are open, which is mostly 0, with the open side in its name. If
// all contacts have a preload, also returns the force at which the first contact opens.
std::vector<HeadlineValue> whatHoldsIt(const Effect::Entries& contacts) {
  double compliance = 0.0;
  for (const element::ElementDescription& entry : contacts) {
    compliance += 1.0 / valueOr(entry, "slack_stiffness", 0.0);
  }
  const bool tension = contacts.front().value("side") > 0.0;
  std::vector<HeadlineValue> result = {
      {tension ? "slack_stiffness_in_compression" : "slack_stiffness_in_tension", "N/m", 1.0 / compliance, false}};
  if (const double preload = leastPreload(contacts); preload > 0.0) {
    result.push_back({"preload", "N", preload, false});
  }
  return result;
}

// Returns a phrase that states which sign of force the contact transmits, or where it opens.
std::vector<std::string> carried(const Effect::Entries& augmented) {
  Effect::Entries contacts;
  std::copy_if(augmented.begin(), augmented.end(), std::back_inserter(contacts),
               [](const element::ElementDescription& entry) { return entry.type == "lift_off"; });
  if (contacts.empty()) {
    return {};
  }
  const bool tension = contacts.front().value("side") > 0.0;
  if (leastPreload(contacts) > 0.0) {
    return {tension ? "opens in compression beyond its preload" : "opens in tension beyond its preload"};
  }
  return {tension ? "carries tension alone" : "carries compression alone"};
}

// A contact that transmits some force while it is open is equivalent to a compliance of one side.
Effect liftOff() {
  Effect effect{115, "lift_off",
                "contact that carries only one sign of force, such as a chevron, strap or spring that is not bonded: "
                "once it opens, the force is 0 or, with a preload, stays at the preload",
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
