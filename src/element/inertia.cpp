// Mass that moves with the actuator.
#include "rubber_suspension/element/inertia.h"

#include <cmath>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::element {
namespace {

enum InertiaSlot { kVelocity, kAcceleration, kLastStep, kStepBeforeLast };

}  // namespace

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

SmoothedInertia::SmoothedInertia(double mass, double bandwidth) : mass_(mass), rate_(2.0 * kPi * bandwidth) {}

// Lags y_k' = w_b (y_(k-1) - y_k) in a row, y_0 = z. Under a ramp of slope v, y_k follows z - k v/w_b; what it deviates
// by decays as exp(-w_b t) times a polynomial of the deviations before it. Kept are y_k - z, which are 0 at rest.
double SmoothedInertia::step(const Motion& motion, double* memory) const {
  const double turn = rate_ * motion.dt;
  const double decay = std::exp(-turn);
  const double lag = motion.increment / turn;
  double deviation[kLags];
  for (std::size_t k = 0; k < kLags; ++k) {
    deviation[k] = memory[k] + static_cast<double>(k + 1) * lag;
  }
  for (std::size_t k = 0; k < kLags; ++k) {
    double sum = 0.0;
    double weight = decay;
    for (std::size_t j = 0; j <= k; ++j) {
      sum += weight * deviation[k - j];
      weight *= turn / static_cast<double>(j + 1);
    }
    memory[k] = sum - static_cast<double>(k + 1) * lag;
  }
  // s^2 H(s) z in terms of the lags' outputs, s/w_b = (1 - L)/L with L = 1/(1 + s/w_b); the weights add up to 0.
  const double bend = 4.0 * memory[0] - 11.0 * memory[1] + 10.0 * memory[2] - 3.0 * memory[3];
  return mass_ * rate_ * rate_ * bend;
}

std::optional<std::complex<double>> SmoothedInertia::complexStiffness(double omega) const {
  const std::complex<double> s(0.0, omega / rate_);
  return -mass_ * omega * omega * (1.0 + 4.0 * s) / std::pow(1.0 + s, 4);
}

ElementType inertiaType() {
  return {"inertia",
          "Mass that moves with the actuator: F = m d2z/dt2.",
          {{"mass", "kg", Role::scale, Range::positive(), "moving mass m between load cell and test piece"},
           {"bandwidth", "Hz", Role::choice, Range::nonNegative(),
            "of a filter for displacements with noise; 0: none, for displacements that are smooth", 0.0}},
          [](const ElementDescription& description) -> ElementPointer {
            const double mass = description.value("mass");
            const double bandwidth = description.value("bandwidth");
            if (bandwidth > 0.0) {
              return std::make_shared<const SmoothedInertia>(mass, bandwidth);
            }
            return std::make_shared<const Inertia>(mass);
          }};
}

}  // namespace rubber_suspension::element
