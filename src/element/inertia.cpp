// Mass that moves with the actuator.
#include "rubber_suspension/element/inertia.h"

#include <algorithm>

namespace rubber_suspension {
namespace {

enum Slot { kVelocity, kAcceleration, kLastStep, kStepBeforeLast };

}  // namespace

double Inertia::rest(double /*displacement*/, double* memory) const {
  std::fill(memory, memory + memorySize(), 0.0);
  return 0.0;
}

double Inertia::step(const Motion& motion, double* memory) const {
  // Before a rest the displacement was constant, so any step length may be assumed there.
  const double dt1 = motion.dt;
  const double dt2 = memory[kLastStep] > 0.0 ? memory[kLastStep] : dt1;
  const double dt3 = memory[kStepBeforeLast] > 0.0 ? memory[kStepBeforeLast] : dt2;
  const double velocity = motion.increment / dt1;
  // A second difference is the acceleration at the mean time of its three samples (exact for a cubic).
  const double acceleration = (velocity - memory[kVelocity]) / (0.5 * (dt1 + dt2));
  const double ahead = (2.0 * dt1 + dt2) / (dt1 + dt2 + dt3);
  const double extrapolated = acceleration + ahead * (acceleration - memory[kAcceleration]);
  memory[kVelocity] = velocity;
  memory[kAcceleration] = acceleration;
  memory[kStepBeforeLast] = dt2;
  memory[kLastStep] = dt1;
  return mass_ * extrapolated;
}

ElementType inertiaType() {
  return {"inertia",
          "Mass that moves with the actuator: F = m d2z/dt2.",
          {{"mass", "kg", Range::positive(), std::nullopt, "moving mass m between load cell and specimen"}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const Inertia>(description.value("mass"));
          }};
}

}  // namespace rubber_suspension
