// Candidate effect: friction, whose limit may depend on displacement, travel or rate.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "diagnosis/effect.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/iwan.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::BasisTerm sliderTerm(double yield, double typical) {
  fit::BasisTerm term;
  term.typical = typical;
  term.at = [yield](double stiffness) {
    return element::ElementDescription{"iwan_table", {{"yield_displacement", {yield}}, {"stiffness", {stiffness}}}};
  };
  return term;
}

void addFriction(const fit::Excitation& excitation, fit::Candidate& candidate) {
  candidate.is_friction = excitation.whole_logs > 1;
  const double typical = 0.1 * excitation.stiffness;
  const double largest = excitation.largest_displacement;
  // Stop operators over the range of amplitudes. With nonnegative stiffnesses they represent any friction that obeys
  // Masing's rule (Coulomb, Dahl, Iwan), and approximate laws that nearly obey it (Berg, Bouc-Wen).
  for (const double share : {0.006, 0.015, 0.035, 0.075, 0.15, 0.27, 0.45, 0.7}) {
    candidate.terms.push_back(sliderTerm(share * largest, typical));
  }
  // Friction whose limit grows fivefold between zero and the largest displacement.
  for (const double share : {0.006, 0.015, 0.035, 0.075, 0.15}) {
    candidate.terms.push_back(
        fit::additiveTerm("variable_friction", "stiffness", typical,
                          {{"yield_displacement", {share * largest}}, {"growth_displacement", {0.25 * largest}}}));
  }
  // Friction that wears within several cycles.
  for (const double share : {0.035, 0.15}) {
    candidate.terms.push_back(fit::additiveTerm("variable_friction", "stiffness", typical,
                                                {{"yield_displacement", {share * largest}},
                                                 {"travel", {40.0 * largest}},
                                                 {"dead_band", {excitation.dead_band}}}));
  }
  // Friction whose limit rises with the rate. Half of the limit is reached at a rate well below the largest rate,
  // because a force that rises up to the largest rate is viscous damping.
  for (const double rate_share : {0.06, 0.2}) {
    for (const double share : {0.006, 0.035}) {
      candidate.terms.push_back(fit::additiveTerm(
          "viscoplastic_friction", "stiffness", typical,
          {{"yield_displacement", {share * largest}}, {"half_rate", {rate_share * excitation.highest_rate}}}));
    }
  }
  // Iwan's law has two parameters. Unlike Berg's and Bouc-Wen's, its memory is not erased by the noise of a sensor.
  for (const double share : {0.003, 0.01, 0.03, 0.1, 0.3}) {
    candidate.laws.push_back(
        fit::additiveTerm("iwan", "maximum_force", typical * share * largest, {{"displacement", {share * largest}}}));
  }
}

// Merges all sliders into one table, which becomes the first entry.
void mergeSliders(Effect::Entries& entries) {
  element::ElementDescription table{"iwan_table", {{"yield_displacement", {}}, {"stiffness", {}}}};
  const auto others = std::stable_partition(entries.begin(), entries.end(),
                                            [&](const auto& entry) { return entry.type == table.type; });
  if (others == entries.begin()) {
    return;
  }
  for (auto slider = entries.begin(); slider != others; ++slider) {
    for (auto& [name, values] : table.values) {
      values.push_back(slider->value(name));
    }
  }
  *entries.begin() = table;
  entries.erase(entries.begin() + 1, others);
}

// Returns the force of an entry whose displacement moves from rest to z. For an infinite z, this is the limit of the
// force. A limit that grows or wears is taken at its initial value, and a limit that rises with the rate at its final
// value.
double forceAt(const element::ElementDescription& entry, double z) {
  if (entry.type == "friction") {
    return entry.value("maximum_force") / (1.0 + entry.value("displacement") / z);
  }
  const std::vector<element::JenkinsSlider> sliders =
      entry.type == "iwan" ? element::iwanSliders(entry.value("maximum_force"), entry.value("displacement"),
                                                  static_cast<int>(element::complete(entry).value("sliders")))
                           : element::slidersFromTable(entry);
  return std::accumulate(sliders.begin(), sliders.end(), 0.0, [&](double force, const element::JenkinsSlider& slider) {
    return force + slider.stiffness * std::min(z, slider.yield_displacement);
  });
}

double forceAt(const Effect::Entries& entries, double z) {
  return std::accumulate(entries.begin(), entries.end(), 0.0,
                         [&](double sum, const auto& entry) { return sum + forceAt(entry, z); });
}

// Returns a force, and the displacement from rest at which half of it is reached.
std::vector<HeadlineValue> forceAndHalf(const Effect::Entries& entries, const char* name, double force) {
  double low = 0.0;
  double high = 1e-9;
  while (forceAt(entries, high) < 0.5 * force) {
    low = std::exchange(high, 2.0 * high);
  }
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (forceAt(entries, middle) < 0.5 * force ? low : high) = middle;
  }
  return {{name, "N", force, true}, {"displacement", "m", high, false}};
}

// Returns the limit of the force, like that of the element `friction`.
std::vector<HeadlineValue> limitOf(const Effect::Entries& entries) {
  return forceAndHalf(entries, "maximum_force", forceAt(entries, std::numeric_limits<double>::infinity()));
}

// Returns half of the width of the largest loop at zero displacement: 2 F(A/2) - F(A) by Masing's rule, with amplitude
// A. Logs determine neither a limit that they do not reach nor a force in phase with the stiffness.
std::vector<HeadlineValue> halfWidthOfLoop(const Effect::Entries& entries, const fit::Excitation& excitation) {
  const double largest = excitation.largest_displacement;
  return forceAndHalf(entries, "force_in_largest_loop",
                      2.0 * forceAt(entries, 0.5 * largest) - forceAt(entries, largest));
}

Effect friction() {
  Effect effect{10, "friction", "friction, whose force has a limit: stiffness falls with amplitude at any frequency",
                false, addFriction};
  effect.tidy = mergeSliders;
  effect.headline = limitOf;
  effect.headline_types = {"iwan_table", "variable_friction", "viscoplastic_friction", "friction", "iwan"};
  effect.sizes = halfWidthOfLoop;
  effect.labels = {{"force_in_largest_loop", "force in the largest loop"}, {"displacement", "half of this force at"}};
  return effect;
}

const EffectEntry kFriction(friction());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
