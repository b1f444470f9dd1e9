// Time-temperature superposition of a table with several temperatures to one curve over frequency.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/fit/measured_table.h"

namespace rubber_suspension::fit {

/// Tolerance of a thermocouple of class 1 (IEC 60584-1) [K]. Temperatures that differ by less are considered equal.
constexpr double kLeastTemperatureRange = 1.5;

/// Returns true if the temperatures of the rows differ by at least kLeastTemperatureRange.
bool hasTemperatures(const std::vector<TablePoint>& points);

/// Shift along the frequency axis of the rows of about one temperature, found without a law.
struct FoundShift {
  double temperature = 0.0;  ///< mean of the rows [degC]
  double decades = 0.0;      ///< log10 a_T; frequency times a_T is the frequency at the reference temperature
  double deviation = 0.0;    ///< standard deviation of `decades`; 0 for the temperature nearest to the reference
};

/// A constant of the law of the shifts, with its uncertainty.
struct ShiftConstant {
  std::string name;  ///< key of the law's parameter
  double value = 0.0;
  double deviation = 0.0;  ///< standard deviation of the constant's logarithm
};

struct MasterCurve {
  element::ElementDescription law;  ///< element wlf_shift or arrhenius_shift
  std::vector<ShiftConstant> constants;
  std::vector<FoundShift> shifts;  ///< ordered from cold to warm
  double misfit = 0.0;             ///< RMS of |K* - K*_series|/|K*| over the rows, shifted by the law
  double misfit_of_shifts = 0.0;   ///< RMS after each temperature was shifted separately

  /// Returns log10 a_T according to the law at a temperature [degC].
  double decadesAt(double temperature) const;

  /// Returns the activation energy [J/mol] with which Arrhenius' law gives the same shift from coldest to warmest rows.
  double activationEnergy() const;
};

/// Shifts rows such that one series of a spring and Maxwell elements (two per decade, no negative stiffness) fits K*
/// best. The shifts are found separately for each temperature, by Arrhenius' law, and by that of Williams, Landel and
/// Ferry. Returns the law with the lower Bayesian information criterion, or Arrhenius' law if a constant of the other
/// law is at its limit. Rows of other amplitudes or mean displacements have their own series and the same shifts. The
/// vertical shift b_T is 1. Standard deviations follow from the misfit and the correlation of neighbouring rows. Throws
/// std::invalid_argument if frequencies of neighbouring temperatures do not overlap after the shift.
/// Source: J. D. Ferry, Viscoelastic Properties of Polymers, 3rd ed., Wiley 1980, ch. 11.
MasterCurve masterCurve(const std::vector<TablePoint>& points, double reference /* T_0 [degC] */);

/// Residuals of the rows of a table after superposition.
struct SuperpositionRest {
  double squares = 0.0;  ///< sum of |K* - K*_series|^2/|K*|^2
  int free = 0;          ///< degrees of freedom: complex numbers of the rows minus half of the fitted parameters
};

/// Returns the residuals with both shifts a_T and b_T free at each temperature, which show how much rows differ from
/// any single curve. Returns nullopt if the table has no temperatures or does not determine the shifts.
std::optional<SuperpositionRest> leftBySuperposition(const std::vector<TablePoint>& points);

/// Returns the integer reference temperature [degC] nearest to the middle of the table.
double middleTemperature(const std::vector<TablePoint>& points);

/// Returns the rows reduced to the reference temperature of the law: frequency times a_T, K* divided by b_T.
std::vector<TablePoint> reducedBy(const element::ElementDescription& law, std::vector<TablePoint> points);

/// Kinds of series that are fitted to rows of one temperature.
enum class Series {
  prony,      ///< a spring and one Maxwell element per decade, without those of stiffness 0
  springpot,  ///< a spring and a springpot
};

/// Returns the elements of the series that fit K* best, from which a fit may start.
std::vector<element::ElementDescription> seriesOf(Series series, const std::vector<TablePoint>& points);

}  // namespace rubber_suspension::fit
