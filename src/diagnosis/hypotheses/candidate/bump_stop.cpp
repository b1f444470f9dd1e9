// Candidate effect: a stop that is in contact only beyond a gap.
#include <algorithm>
#include <limits>
#include <utility>

#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addBumpStop(const fit::Excitation& excitation, fit::Candidate& candidate) {
  // A stop between two gaps of the list below needs two terms on each side. More terms represent a smooth curve.
  candidate.terms_of_one = 4;
  for (const double side : {0.0, 1.0, -1.0}) {
    for (const double share : {0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
      const element::ParameterValues place = {{"gap", {share * excitation.largest_displacement}}, {"side", {side}}};
      candidate.terms.push_back(fit::additiveTerm("bump_stop", "stiffness", excitation.stiffness, place));
      element::ParameterValues of_rubber = place;
      of_rubber["exponent"] = {1.5};
      candidate.laws.push_back(fit::additiveTerm("bump_stop", "stiffness", excitation.stiffness, of_rubber));
    }
  }
}

// Returns, for each side, the displacement at which the force begins, and the slope once all its stops are in contact.
std::vector<HeadlineValue> bySide(const Effect::Entries& stops) {
  std::vector<HeadlineValue> result;
  for (const auto& [side, suffix] :
       {std::pair(0.0, ""), std::pair(1.0, "_in_tension"), std::pair(-1.0, "_in_compression")}) {
    double gap = std::numeric_limits<double>::infinity();
    double stiffness = 0.0;
    for (const element::ElementDescription& stop : stops) {
      if (valueOr(stop, "side", 0.0) == side) {
        gap = std::min(gap, stop.value("gap"));
        stiffness += stop.value("stiffness");
      }
    }
    if (stiffness > 0.0) {
      result.push_back({std::string("gap") + suffix, "m", gap, false});
      result.push_back({std::string("stiffness") + suffix, "N/m", stiffness, true});
    }
  }
  return result;
}

Effect bumpStop() {
  Effect effect{70, "bump_stop",
                "stop behind a gap on one or both sides: the force has a knee, and the error lies beyond the knee",
                false, addBumpStop};
  effect.headline = bySide;
  effect.headline_types = {effect.name};
  return effect;
}

const EffectEntry kBumpStop(bumpStop());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
