// Dashpot whose force follows a power of the rate.
#include "rubber_suspension/element/power_dashpot.h"

#include <cmath>

namespace rubber_suspension::element {

PowerDashpot::PowerDashpot(double damping, double reference_rate, double exponent)
    : damping_(damping), reference_rate_(reference_rate), exponent_(exponent) {}

double PowerDashpot::force(double rate) const {
  return std::copysign(damping_ * reference_rate_ * std::pow(std::abs(rate) / reference_rate_, exponent_), rate);
}

ElementType powerDashpotType() {
  return {"power_dashpot",
          "Dashpot whose force follows a power of the rate, F = c v_r sign(v) |v/v_r|^p, v = dz/dt.",
          {{"damping", "N s/m", Role::scale, Range::positive(), "damping constant c at the rate v_r"},
           {"reference_rate", "m/s", Role::reference, Range::positive(), "rate v_r at which the damping holds"},
           {"exponent", "1", Role::shape, Range::openBelow(0.0, 4.0), "power p; 1: a linear dashpot"}},
          makes<PowerDashpot>("damping", "reference_rate", "exponent")};
}

}  // namespace rubber_suspension::element
