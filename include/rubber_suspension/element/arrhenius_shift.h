// Shift by the law of Arrhenius. Throws nothing.
#pragma once

#include "rubber_suspension/element/vertical_shift.h"

namespace rubber_suspension::element {

/// ln a_T = E/R (1/T - 1/T_0) with T in K, b_T = 1 + beta (T - T_0).
///
/// Validity: further than about 100 K above T_g, or over a few tens of kelvin anywhere with E as the slope there (of
/// WLF at its reference: E = ln(10) R T_0^2 C_1/C_2); taken as far as 20 decades to the slow side. A negative E, which
/// no rubber has, takes back too much of another shift.
/// Source: J. D. Ferry, Viscoelastic Properties of Polymers, 3rd ed., Wiley 1980, ch. 11.
class ArrheniusShift final : public TemperatureShift {
 public:
  struct Parameters {
    double activation_energy;  ///< E [J/mol]
    double reference;          ///< T_0 [degC]
    double vertical;           ///< beta [1/K]
  };

  static constexpr double kGasConstant = 8.31446261815324;  ///< R [J/(mol K)], exact in the SI

  explicit ArrheniusShift(const Parameters& parameters)
      : parameters_(parameters), vertical_(parameters.vertical, parameters.reference) {}

  Shift at(double temperature) const override;
  Range temperatures() const override;

 private:
  Parameters parameters_;
  VerticalShift vertical_;
};

ElementType arrheniusShiftType();

}  // namespace rubber_suspension::element
