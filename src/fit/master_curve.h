// One curve over frequency from the rows of a table at several temperatures, by time-temperature superposition.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/fit/measured_table.h"

namespace rubber_suspension::fit {

/// The tolerance of a thermocouple of class 1 (IEC 60584-1) [K]: temperatures that differ by less count as equal.
constexpr double kLeastTemperatureRange = 1.5;

/// Returns true if the temperatures of the rows differ by at least kLeastTemperatureRange.
bool hasTemperatures(const std::vector<TablePoint>& points);

/// Shift of the rows of about one temperature along the axis of frequency, found without a law.
struct FoundShift {
  double temperature = 0.0;  ///< mean of the rows [degC]
  double decades = 0.0;      ///< log10 a_T: their frequencies times a_T are those at the reference
  double deviation = 0.0;    ///< standard deviation of `decades`; 0 for the temperature nearest to the reference
};

/// A constant of the law of the shifts.
struct ShiftConstant {
  std::string name;  ///< as a key of the law
  double value = 0.0;
  double deviation = 0.0;  ///< standard deviation of its logarithm
};

struct MasterCurve {
  element::ElementDescription law;  ///< a wlf_shift or arrhenius_shift
  std::vector<ShiftConstant> constants;
  std::vector<FoundShift> shifts;  ///< from cold to warm
  double misfit = 0.0;             ///< RMS of |K* - K*_series|/|K*| over the rows, shifted by the law
  double misfit_of_shifts = 0.0;   ///< likewise, with each temperature shifted separately

  /// Returns log10 a_T of the law at a temperature [degC].
  double decadesAt(double temperature) const;

  /// Returns the activation energy with which Arrhenius' law shifts the coldest and warmest rows as far apart [J/mol].
  double activationEnergy() const;
};

/// Shifts rows such that a spring and Maxwell elements, two a decade and none of negative stiffness, fit K* best: each
/// temperature separately, by Arrhenius, and by Williams, Landel and Ferry. Returns the law with the lower Bayesian
/// information criterion, but Arrhenius' if a constant of the other is at its limit. Rows of other amplitudes or mean
/// displacements have separate series and the same shifts; b_T is 1. Deviations follow from the misfit, with the
/// correlation of neighbouring rows. Throws std::invalid_argument if frequencies of neighbouring temperatures do not
/// overlap when shifted, because their distance is then undetermined.
/// Source: J. D. Ferry, Viscoelastic Properties of Polymers, 3rd ed., Wiley 1980, ch. 11.
MasterCurve masterCurve(const std::vector<TablePoint>& points, double reference /* T_0 [degC] */);

/// Residuals of rows after superposition.
struct SuperpositionRest {
  double squares = 0.0;  ///< sum of |K* - K*_series|^2/|K*|^2
  int free = 0;          ///< complex numbers of the rows, less half of the parameters of shifts and series
};

/// Returns the residuals with a_T and b_T free at each temperature: the difference of the rows from any single curve;
/// nullopt if the table has no temperatures or does not determine the shifts.
std::optional<SuperpositionRest> leftBySuperposition(const std::vector<TablePoint>& points);

/// Returns a reference temperature [degC]: the whole number nearest to the middle of the table.
double middleTemperature(const std::vector<TablePoint>& points);

/// Returns the rows as they would be at the reference of the law: frequency times a_T, K* over b_T.
std::vector<TablePoint> reducedBy(const element::ElementDescription& law, std::vector<TablePoint> points);

/// Elements of a series that is fitted to rows of one temperature.
enum class Series {
  prony,      ///< a spring and a Maxwell element for each decade, where its stiffness is not 0
  springpot,  ///< a spring and a springpot
};

/// Returns the elements of the series that fit K* best, as the start of a fit.
std::vector<element::ElementDescription> seriesOf(Series series, const std::vector<TablePoint>& points);

}  // namespace rubber_suspension::fit
