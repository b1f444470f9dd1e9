// Candidate effect: rates and stiffness that follow the temperature of the logs.
#include <cmath>

#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

constexpr double kLeastRange = 1.5;  // [K]; the tolerance of a thermocouple of class 1 (IEC 60584-1) is as much

// Rates by one activation energy: over some tens of kelvin what any law of temperature is.
fit::BasisTerm rates(double reference) {
  constexpr double kTypical = 3e4;  // [J/mol]; natural rubber at 20 degC has 7e4, far above T_g all have some 1e4
  constexpr double kMost = 2e5;     // 16 decades from 40 down to -60 degC; the law holds to 20
  fit::BasisTerm term =
      fit::additiveTerm("arrhenius_shift", "activation_energy", kTypical, {{"reference", {reference}}});
  term.additive = false;
  term.lower = -kMost;  // what the component's own shift has too much
  term.upper = kMost;
  return term;
}

// Stiffness that rises as entropy has it, or falls as fillers do.
fit::BasisTerm stiffness(double reference, double reach) {
  constexpr double kTypical = 3e-3;  // [1/K]; entropy 1/293, fillers some 0.1 to 1 % per kelvin
  fit::BasisTerm term = fit::additiveTerm("vertical_shift", "coefficient", kTypical, {{"reference", {reference}}});
  term.additive = false;
  term.upper = 0.8 / (2.0 * reach + 20.0);  // positive also on logs that are twice as far from the reference
  term.lower = -term.upper;
  return term;
}

// Stiffness that rises the faster the colder it is.
fit::BasisTerm transition(double reference, double width) {
  fit::BasisTerm term =
      fit::additiveTerm("transition_shift", "share", 0.05, {{"width", {width}}, {"reference", {reference}}});
  term.additive = false;
  term.upper = 0.9;
  return term;
}

fit::Candidate temperature(const fit::Excitation& excitation) {
  fit::Candidate candidate{"temperature",
                           "rates and stiffness that follow the temperature: the gap goes with the column "
                           "temperature_degC, which logs need for it",
                           false,
                           {}};
  const double range = excitation.highest_temperature - excitation.lowest_temperature;
  if (excitation.has_temperature && range >= kLeastRange) {
    const double reference = std::round(0.5 * (excitation.lowest_temperature + excitation.highest_temperature));
    candidate.terms = {rates(reference), stiffness(reference, range), transition(reference, 0.5 * range)};
  }
  return candidate;
}

const CandidateEntry kTemperatureEntry(105, temperature);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
