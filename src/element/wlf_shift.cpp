// Temperature shift by the equation of Williams, Landel and Ferry.
#include <cmath>

#include "element/registry.h"
#include "element/shift_parts.h"

namespace rubber_suspension::element {
namespace {

/// Shifts by log10 a_T = -C_1 (T - T_0)/(C_2 + T - T_0), b_T = 1 + beta (T - T_0).
///
/// C_1 and C_2 depend on the reference temperature, but C_1 C_2 and T_0 - C_2 do not. So constants C_1 and C_2 for the
/// reference temperature T_g become C_1 C_2/(C_2 + T_0 - T_g) and C_2 + T_0 - T_g for T_0. Without data, use C_1 =
/// 17.44 and C_2 = 51.6 K for T_g. Validity: from T_g to about T_g + 100 K. The equation is singular at T_0 - C_2, so
/// the range of temperatures begins where the shift is 20 decades.
/// Source: M. L. Williams, R. F. Landel, J. D. Ferry, J. Am. Chem. Soc. 77 (1955) 3701-3707; constants of rubbers: J.
/// D. Ferry, Viscoelastic Properties of Polymers, 3rd ed., Wiley 1980, table 11-II.
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

  Shift at(double temperature) const override {
    const double above = temperature - parameters_.reference;
    return {std::pow(10.0, -parameters_.c1 * above / (parameters_.c2 + above)), vertical_.at(temperature).force};
  }

  Range temperatures() const override {
    // At the lowest temperature, -C_1 x/(C_2 + x) = kMostDecades with x = T - T_0.
    const double lowest = parameters_.reference - parameters_.c2 * kMostDecades / (kMostDecades + parameters_.c1);
    Range range;
    range.lower = lowest;
    return intersection(vertical_.temperatures(), range);
  }

 private:
  Parameters parameters_;
  VerticalShift vertical_;
};

const ElementEntry kWlfShiftEntry(
    350, {"wlf_shift",
          "Shift of all rates with temperature by Williams, Landel and Ferry, log10 a_T = -C_1 (T - T_0)/(C_2 + T - "
          "T_0); the key `temperature` of a component creates it.",
          {{"c1", "1", Role::shape, Range::openBelow(0.0, 100.0), "constant C_1 at the reference temperature"},
           {"c2", "K", Role::shape, Range::openBelow(0.0, 1000.0),
            "constant C_2 at the reference temperature, a temperature difference"},
           referenceParameter(),
           verticalParameter("vertical", 0.0)},
          makes<WlfShift, WlfShift::Parameters>("c1", "c2", "reference", "vertical")});

}  // namespace
}  // namespace rubber_suspension::element
