// Temperature shift by the law of Arrhenius.
#include <cmath>

#include "element/registry.h"
#include "element/shift_parts.h"

namespace rubber_suspension::element {
namespace {

/// Shifts by ln a_T = E/R (1/T - 1/T_0) with T in K, and b_T = 1 + beta (T - T_0).
///
/// Validity: more than about 100 K above T_g, or a few tens of kelvin around any temperature with E as the local slope
/// (of a WLF shift at T_0: E = ln(10) R T_0^2 C_1/C_2). Towards low temperatures the shift is limited to 20 decades. A
/// negative E, which no rubber has, corrects another shift that is too large.
/// Source: J. D. Ferry, Viscoelastic Properties of Polymers, 3rd ed., Wiley 1980, ch. 11.
class ArrheniusShift final : public TemperatureShift {
 public:
  struct Parameters {
    double activation_energy;  ///< E [J/mol]
    double reference;          ///< T_0 [degC]
    double vertical;           ///< beta [1/K]
  };

  explicit ArrheniusShift(const Parameters& parameters)
      : parameters_(parameters), vertical_(parameters.vertical, parameters.reference) {}

  Shift at(double temperature) const override {
    // 1/T - 1/T_0 without cancellation, exactly 0 at T_0.
    const double reference = parameters_.reference + kZeroCelsius;
    const double absolute = temperature + kZeroCelsius;
    const double difference = (parameters_.reference - temperature) / (absolute * reference);
    return {std::exp(parameters_.activation_energy / kGasConstant * difference), vertical_.at(temperature).force};
  }

  Range temperatures() const override {
    Range range = vertical_.temperatures();
    if (parameters_.activation_energy == 0.0) {
      return range;
    }
    const double inverse = 1.0 / (parameters_.reference + kZeroCelsius) +
                           kMostDecades * std::log(10.0) * kGasConstant / parameters_.activation_energy;
    if (inverse > 0.0) {
      const double end = 1.0 / inverse - kZeroCelsius;
      Range slow;
      (parameters_.activation_energy > 0.0 ? slow.lower : slow.upper) = end;
      range = intersection(range, slow);
    }
    return range;
  }

 private:
  Parameters parameters_;
  VerticalShift vertical_;
};

constexpr double kMost = 1e6;  // [J/mol]; the largest values of rubbers, at the glass transition, are half of it

const ElementEntry kArrheniusShiftEntry(360,
                                        {"arrhenius_shift",
                                         "Shift of all rates with temperature by Arrhenius, ln a_T = E/R (1/T - "
                                         "1/T_0); the key `temperature` of a component creates it.",
                                         {{"activation_energy", "J/mol", Role::shape, Range::closed(-kMost, kMost),
                                           "activation energy E; negative only to cancel another shift"},
                                          referenceParameter(),
                                          verticalParameter("vertical", 0.0)},
                                         makes<ArrheniusShift, ArrheniusShift::Parameters>("activation_energy",
                                                                                           "reference", "vertical")});

}  // namespace
}  // namespace rubber_suspension::element
