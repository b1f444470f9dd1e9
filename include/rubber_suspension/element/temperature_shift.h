// Interface of the laws by which temperature scales the rates and the force of a test piece. Throws nothing.
#pragma once

#include "rubber_suspension/element/element.h"
#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::element {

constexpr double kZeroCelsius = 273.15;  ///< 0 degC [K]

/// Factors of time-temperature superposition: K*(omega, T) = b_T K*(a_T omega, T_0).
struct Shift {
  double time = 1.0;   ///< a_T: a process of 1 s at T_0 lasts a_T s
  double force = 1.0;  ///< b_T, on the force of the test piece
};

/// Base of the laws of temperature. The factors of several such laws are multiplied.
///
/// All rates in the elements of the test piece (relaxation, dashpots, build-up of structure) refer to the reduced time,
/// the integral of dt/a_T, and the force of these elements is multiplied by b_T. In terms of reduced time and reduced
/// force each element is the same at any temperature (thermorheologically simple), so a change of the temperature alone
/// changes no state. The rig, delay, series compliance, self-heating and the recovery of stress softening refer to the
/// real time. Source: J. D. Ferry, Viscoelastic Properties of Polymers, 3rd ed., Wiley 1980, ch. 11; L. W. Morland, E.
/// H. Lee, Trans. Soc. Rheol. 4 (1960) 233-263 (temperature that changes).
class TemperatureShift : public Element {
 public:
  /// Returns the factors at a temperature [degC] within temperatures().
  virtual Shift at(double temperature) const = 0;

  /// Returns the range in which the law is valid [degC].
  virtual Range temperatures() const = 0;

  Action action() const final { return Action::shifts_with_temperature; }
  /// The law is linear at constant temperature.
  bool linear() const final { return true; }
  /// A component whose temperature changes between loading and unloading may return more energy than it received.
  bool passive() const final { return false; }
};

/// Largest shift in decades at which a law is valid.
constexpr double kMostDecades = 20.0;

/// Returns the intersection of two ranges.
Range intersection(const Range& a, const Range& b);

/// Returns the row of the parameter beta in b_T = 1 + beta (T - T_0).
ParameterInfo verticalParameter(const std::string& name, const std::optional<double>& default_value);

/// Returns the row of the parameter T_0, the reference temperature.
ParameterInfo referenceParameter();

}  // namespace rubber_suspension::element
