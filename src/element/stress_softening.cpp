// Stress softening.
#include "rubber_suspension/element/stress_softening.h"

#include <algorithm>
#include <cmath>

#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {
namespace {

enum SofteningSlot { kLargest, kReach };

StressSoftening::Parameters parametersFrom(const ElementDescription& description) {
  StressSoftening::Parameters parameters{description.value("reduction"), description.value("width"),
                                         description.value("path")};
  parameters.reach_exponent = description.value("reach_exponent");
  parameters.full_reach = description.value("full_reach");
  parameters.recovery_time = description.value("recovery_time");
  parameters.ratio_power = description.value("ratio_power");
  parameters.side = static_cast<StressSoftening::Side>(sideOf(description, "z"));
  if (parameters.reach_exponent > 0.0 && parameters.full_reach == 0.0) {
    refuseValue(description.type, "full_reach", 0.0, "m", "greater than 0 beside a reach_exponent");
  }
  return parameters;
}

// Without std::pow for the powers that a fit tries most.
double powerOf(double base, double exponent) {
  if (exponent == 1.0) {
    return base;
  }
  return exponent == 2.0 ? base * base : std::pow(base, exponent);
}

// tanh with an absolute rounding, which is all that a factor needs; its relative one near 0 would cost more.
double tanhOf(double value) { return 1.0 - 2.0 / (1.0 + std::exp(2.0 * value)); }

}  // namespace

StressSoftening::StressSoftening(const Parameters& parameters)
    : parameters_(parameters), deepest_(std::tanh(1.0 / parameters.width)) {}

double StressSoftening::reachOf(double displacement) const {
  return parameters_.side == Side::both ? std::abs(displacement)
                                        : std::max(0.0, static_cast<double>(parameters_.side) * displacement);
}

void StressSoftening::initialise(double displacement, double* memory) const {
  memory[kLargest] = memory[kReach] = reachOf(displacement);
}

// A long rest heals what heals at all; else only a displacement beyond all before counts again.
double StressSoftening::relax(double displacement, double* memory) const {
  if (parameters_.recovery_time > 0.0) {
    initialise(displacement, memory);
    return 1.0;
  }
  memory[kLargest] = std::max(memory[kLargest], reachOf(displacement));
  if (parameters_.path == 0.0) {
    memory[kReach] = memory[kLargest];
  }
  return factor(displacement, memory[kReach]);
}

double StressSoftening::reductionAt(double reach) const {
  const double exponent = parameters_.reach_exponent;
  return exponent == 0.0 ? parameters_.reduction
                         : parameters_.reduction * powerOf(std::min(reach / parameters_.full_reach, 1.0), exponent);
}

double StressSoftening::shareOfSide(double displacement, double reach) const {
  constexpr double kBlended = 0.25;  // of the reach, to either side of zero
  if (parameters_.side == Side::both) {
    return 1.0;
  }
  const double beyond = static_cast<double>(parameters_.side) * displacement / (kBlended * reach);
  return std::clamp(0.5 * (1.0 + beyond), 0.0, 1.0);
}

double StressSoftening::factor(double displacement, double reach) const {
  if (std::abs(displacement) >= reach) {
    return 1.0;
  }
  const double ratio = std::abs(displacement) / reach;
  const double lacking = (1.0 - powerOf(ratio, parameters_.ratio_power)) / parameters_.width;
  return 1.0 - reductionAt(reach) * shareOfSide(displacement, reach) * tanhOf(lacking) / deepest_;
}

// Towards the reach of the present displacement.
void StressSoftening::recover(double dt, double reached, double* memory) const {
  const double kept = Relaxation::over(dt / parameters_.recovery_time).decay;
  for (const SofteningSlot slot : {kLargest, kReach}) {
    memory[slot] = std::min(memory[slot], reached + std::max(0.0, memory[slot] - reached) * kept);
  }
}

double StressSoftening::step(const Motion& motion, const ComponentForce& /*force*/, double* memory) const {
  const double reached = reachOf(motion.displacement);
  if (parameters_.recovery_time > 0.0) {
    recover(motion.dt, reached, memory);
  }
  memory[kLargest] = std::max(memory[kLargest], reached);
  if (parameters_.path == 0.0) {
    memory[kReach] = memory[kLargest];
  } else if (memory[kReach] < memory[kLargest]) {
    const double kept = Relaxation::over(std::abs(motion.increment) / parameters_.path).decay;
    memory[kReach] += (memory[kLargest] - memory[kReach]) * (1.0 - kept);
  }
  return factor(motion.displacement, memory[kReach]);
}

ElementType stressSofteningType() {
  return {"stress_softening",
          "Mullins effect: softer within displacements that were reached before.",
          {{"reduction", "1", Role::shape, Range::closed(0.0, 0.9), "share R of the force that is lost deep within"},
           {"width", "1", Role::shape, Range::closed(0.01, 10.0),
            "width w of the transition, as a share of that power at the largest past displacement", 0.5},
           {"path", "m", Role::shape, Range::nonNegative(), "travel over which softening sets in; 0: at once", 0.0},
           {"reach_exponent", "1", Role::shape, Range::closed(0.0, 4.0),
            "power q of the reach by which the reduction grows; 0: the same at any reach", 0.0},
           {"full_reach", "m", Role::shape, Range::nonNegative(),
            "largest past displacement at which the reduction is R and from which on it grows no more", 0.0},
           {"recovery_time", "s", Role::shape, Range::nonNegative(),
            "time over which softening is lost again; 0: permanent", 0.0},
           {"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: softens at z > 0 only, -1: at z < 0 only, 0: both",
            0.0},
           {"ratio_power", "1", Role::choice, Range::closed(0.5, 8.0),
            "power a of the displacement over the reach by which the transition goes; 2: by energy, 1: by "
            "displacement",
            2.0}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const StressSoftening>(parametersFrom(description));
          }};
}

}  // namespace rubber_suspension::element
