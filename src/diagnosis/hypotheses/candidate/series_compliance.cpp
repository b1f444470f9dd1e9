// Candidate effect: a compliant bracket or rig.
#include <algorithm>
#include <utility>

#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::BasisTerm complianceTerm(const fit::Excitation& excitation, double closing_force, double side) {
  fit::BasisTerm term;
  term.at = [closing_force, side](double compliance) {
    element::ElementDescription entry{"series_compliance", {{"stiffness", {1.0 / compliance}}}};
    if (closing_force > 0.0) {
      entry.values["closing_force"] = {closing_force};
    } else {
      entry.values["side"] = {side};
    }
    return entry;
  };
  term.typical = 0.05 / excitation.stiffness;
  term.upper = 1.0 / excitation.stiffness;
  term.additive = false;
  term.refines = closing_force > 0.0;
  return term;
}

// Adds a compliance for each side, and one that closes under load. Together they cover asymmetry and hardening.
void addSeriesCompliance(const fit::Excitation& excitation, fit::Candidate& candidate) {
  constexpr double kClosing = 0.5;  // divided by the largest force of a spring with the stiffness of the logs
  const double closing_force = kClosing * excitation.stiffness * excitation.largest_displacement;
  candidate.terms = {complianceTerm(excitation, 0.0, 1.0), complianceTerm(excitation, 0.0, -1.0),
                     complianceTerm(excitation, closing_force, 0.0)};
}

// Merges the compliances of the two sides into a common one and one for the remainder of the softer side.
void mergeSides(Effect::Entries& entries) {
  const auto ofSide = [&](double side) {
    return std::find_if(entries.begin(), entries.end(), [&](const element::ElementDescription& entry) {
      return entry.type == "series_compliance" && entry.values.count("side") != 0 && entry.value("side") == side;
    });
  };
  auto stiff = ofSide(1.0);
  auto soft = ofSide(-1.0);
  if (stiff == entries.end() || soft == entries.end()) {
    return;
  }
  if (stiff->value("stiffness") < soft->value("stiffness")) {
    std::swap(stiff, soft);
  }
  const double rest = 1.0 / soft->value("stiffness") - 1.0 / stiff->value("stiffness");
  stiff->values.erase("side");
  if (rest > 0.0) {
    soft->values["stiffness"] = {1.0 / rest};
  } else {
    entries.erase(soft);
  }
}

// Returns the headline numbers of each compliance by itself, because stiffnesses in series do not add up.
std::vector<HeadlineValue> eachOf(const Effect::Entries& compliances) {
  std::vector<HeadlineValue> result;
  for (const element::ElementDescription& entry : compliances) {
    for (HeadlineValue value : movedOf({entry})) {
      const double side = valueOr(entry, "side", 0.0);
      value.name += side > 0.0 ? "_in_tension" : side < 0.0 ? "_in_compression" : "";
      value.name += entry.values.count("closing_force") != 0 && compliances.size() > 1 ? "_that_closes" : "";
      result.push_back(value);
    }
  }
  return result;
}

Effect seriesCompliance() {
  Effect effect{110, "series_compliance",
                "compliance of rig, bracket or joint, equal or different in the two directions: the error grows with "
                "stiffness at any frequency",
                true, addSeriesCompliance};
  effect.tidy = mergeSides;
  effect.headline = eachOf;
  effect.headline_types = {effect.name};
  return effect;
}

const EffectEntry kSeriesCompliance(seriesCompliance());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
