// Parts of temperature shifts: the gas constant, and the shift that acts on the force alone.
#pragma once

#include "rubber_suspension/element/temperature_shift.h"

namespace rubber_suspension::element {

constexpr double kGasConstant = 8.31446261815324;  ///< R [J/(mol K)], exact in the SI

/// Shifts by b_T = 1 + beta (T - T_0), a_T = 1.
///
/// For the entropic elasticity of rubber, b_T = T rho/(T_0 rho_0), beta is 1/T_0 minus the volumetric coefficient of
/// thermal expansion (T_0 in K); filled rubbers instead soften with temperature, by some 0.1 to 1 % per kelvin. Valid
/// where the factor is positive. Source: J. D. Ferry, Viscoelastic Properties of Polymers, 3rd ed., Wiley 1980, ch. 11.
class VerticalShift final : public TemperatureShift {
 public:
  VerticalShift(double coefficient /* beta [1/K] */, double reference /* T_0 [degC] */)
      : coefficient_(coefficient), reference_(reference) {}

  Shift at(double temperature) const override { return {1.0, 1.0 + coefficient_ * (temperature - reference_)}; }
  Range temperatures() const override {
    const Range above_zero{-kZeroCelsius, Range::any().upper, true, false};
    if (coefficient_ == 0.0) {
      return above_zero;
    }
    const double end = reference_ - 1.0 / coefficient_;
    Range positive;
    if (coefficient_ > 0.0) {
      positive.lower = end;
      positive.open_lower = true;
    } else {
      positive.upper = end;
      positive.open_upper = true;
    }
    return intersection(above_zero, positive);
  }

 private:
  double coefficient_;
  double reference_;
};

}  // namespace rubber_suspension::element
