// Shift by the equation of Williams, Landel and Ferry. Throws nothing.
#pragma once

#include "rubber_suspension/element/vertical_shift.h"

namespace rubber_suspension::element {

/// log10 a_T = -C_1 (T - T_0)/(C_2 + T - T_0), b_T = 1 + beta (T - T_0).
///
/// C_1 and C_2 belong to their reference: C_1 C_2 and T_0 - C_2 are the same at any reference, so constants at T_g turn
/// into those at T_0 by C_2 + T_0 - T_g and C_1 C_2/(C_2 + T_0 - T_g). Where nothing is known C_1 = 17.44 and
/// C_2 = 51.6 K at T_g.
/// Validity: from T_g to about T_g + 100 K; the equation has no value at T_0 - C_2 and below, and is taken as far as
/// 20 decades above that.
/// Source: M. L. Williams, R. F. Landel, J. D. Ferry, J. Am. Chem. Soc. 77 (1955) 3701-3707; constants of rubbers:
/// J. D. Ferry, Viscoelastic Properties of Polymers, 3rd ed., Wiley 1980, table 11-II.
class WlfShift final : public TemperatureShift {
 public:
  struct Parameters {
    double c1;         ///< C_1 [-]
    double c2;         ///< C_2 [K]
    double reference;  ///< T_0 [degC]
    double vertical;   ///< beta [1/K]
  };

  explicit WlfShift(const Parameters& parameters)
      : parameters_(parameters), vertical_(parameters.vertical, parameters.reference) {}

  Shift at(double temperature) const override;
  Range temperatures() const override;

 private:
  Parameters parameters_;
  VerticalShift vertical_;
};

ElementType wlfShiftType();

}  // namespace rubber_suspension::element
