// Candidate effect: rates and a stiffness that depend on the temperature of the logs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/effect.h"
#include "element/shift_parts.h"
#include "fit/master_curve.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// Returns by how many decades an activation energy of 1 J/mol shifts times from the highest to the lowest temperature.
double decadesPerEnergy(const fit::Excitation& excitation) {
  const auto inverse = [](double temperature) { return 1.0 / (temperature + element::kZeroCelsius); };
  return (inverse(excitation.lowest_temperature) - inverse(excitation.highest_temperature)) /
         (std::log(10.0) * element::kGasConstant);
}

// Returns the largest activation energy. It may be negative, to correct a configured shift that is too large.
double largestEnergy(const fit::Excitation& excitation) {
  constexpr double kMost = 5e5;          // in J/mol, at the glass transition
  constexpr double kMostDecades = 16.0;  // decades over the range of the logs; the law is valid up to 20
  return std::min(kMost, kMostDecades / decadesPerEnergy(excitation));
}

// Returns a shift with one activation energy, which approximates any law of temperature over tens of kelvin.
fit::BasisTerm rates(const fit::Excitation& excitation, double reference) {
  constexpr double kTypical = 3e4;  // [J/mol]; natural rubber at 20 degC: 7e4; far above the glass transition: 1e4
  fit::BasisTerm term =
      fit::additiveTerm("arrhenius_shift", "activation_energy", kTypical, {{"reference", {reference}}});
  term.additive = false;
  term.upper = largestEnergy(excitation);
  term.lower = -term.upper;
  term.start = std::min(excitation.activation_energy, term.upper);
  return term;
}

// Adds relaxation that only the shift moves to the frequencies of the logs. At these frequencies, an unshifted branch
// acts as a spring or adds no force, apart from about 1 % of its largest stiffness.
void addRelaxationBeyond(const fit::Excitation& excitation, std::vector<fit::BasisTerm>& terms) {
  const auto add = [&](double frequency) {
    terms.push_back(
        fit::additiveTerm("maxwell", "stiffness", 0.1 * excitation.stiffness, {{"break_frequency", {frequency}}}));
    terms.back().upper = excitation.stiffness;
    terms.back().additive = false;  // because it shifts
    terms.back().start = terms.back().typical;
  };
  const double reach = 0.5 * excitation.activation_energy * decadesPerEnergy(excitation);  // decades to either side
  for (double decades = 2.0; decades <= std::ceil(reach); decades += 1.0) {
    add(std::pow(10.0, -decades) / excitation.longest_duration);
    add(std::pow(10.0, decades) * excitation.highest_frequency);
  }
}

// Returns a stiffness that changes with temperature. It rises due to entropy elasticity, or falls, as in filled rubber.
fit::BasisTerm stiffness(double reference, double reach) {
  constexpr double kTypical = 3e-3;  // in 1/K; 1/293 for entropy elasticity, 0.001 to 0.01 for fillers
  fit::BasisTerm term = fit::additiveTerm("vertical_shift", "coefficient", kTypical, {{"reference", {reference}}});
  term.additive = false;
  term.upper = 0.8 / (2.0 * reach + 20.0);  // keeps the stiffness positive far outside the temperatures of the logs
  term.lower = -term.upper;
  return term;
}

// Returns a stiffness that rises more steeply at lower temperatures, towards the glass transition.
fit::BasisTerm transition(double reference, double width) {
  fit::BasisTerm term =
      fit::additiveTerm("transition_shift", "share", 0.05, {{"width", {width}}, {"reference", {reference}}});
  term.additive = false;
  term.upper = 0.9;
  return term;
}

void addTemperature(const fit::Excitation& excitation, fit::Candidate& candidate) {
  const double range = excitation.highest_temperature - excitation.lowest_temperature;
  if (excitation.has_temperature && range >= fit::kLeastTemperatureRange) {
    const double reference = std::round(0.5 * (excitation.lowest_temperature + excitation.highest_temperature));
    candidate.terms = {rates(excitation, reference), stiffness(reference, range), transition(reference, 0.5 * range)};
    addRelaxationBeyond(excitation, candidate.terms);
  }
}

// Returns the relative changes of stiffness and of rates per kelvin at the reference temperature.
std::vector<HeadlineValue> changesPerKelvin(const Effect::Entries& entries) {
  double stiffness = 0.0;
  double rates = 0.0;
  for (const element::ElementDescription& entry : entries) {
    const double reference = entry.value("reference") + element::kZeroCelsius;
    stiffness += valueOr(entry, "coefficient", 0.0) + valueOr(entry, "vertical", 0.0) -
                 valueOr(entry, "share", 0.0) / valueOr(entry, "width", 1.0);
    rates += valueOr(entry, "activation_energy", 0.0) / (element::kGasConstant * reference * reference) +
             std::log(10.0) * valueOr(entry, "c1", 0.0) / valueOr(entry, "c2", 1.0);
  }
  std::vector<HeadlineValue> result;
  for (const auto& [name, value] : {std::pair("stiffness", stiffness), std::pair("rates", rates)}) {
    if (value != 0.0) {
      result.push_back(
          {fmt::format("change_of_{}_at_{:g}_degC", name, entries.front().value("reference")), "1/K", value, true});
    }
  }
  return result;
}

Effect temperature() {
  Effect effect{
      105, "temperature",
      "rates and stiffness that depend on temperature: the gap follows the temperature; only for logs with the "
      "column temperature_degC",
      false, addTemperature};
  effect.headline = changesPerKelvin;
  effect.headline_types = {"arrhenius_shift", "transition_shift", "vertical_shift", "wlf_shift"};
  return effect;
}

const EffectEntry kTemperature(temperature());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
