// Mass that moves with the actuator: fixture, load cell, or the rubber's own share.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension {

/// F = m d2z/dt2, K* = -m w^2: lowers the measured stiffness as f^2, in phase.
/// The acceleration at a sample is extrapolated linearly from the second differences of the last four samples, exact
/// for a cubic z(t) at any step lengths, so that the force is neither late nor lossy: relative error 11/12 (w dt)^2
/// under a sine. Noise of standard deviation s on z makes about 6.8 m s/dt^2 of noise on F; smooth the displacement
/// first where that matters. A kink of z(t) gives a pulse of force over three steps. Memory: velocity and second
/// difference of the step before, and the last two step lengths (0 after a rest). Source: fixture mass of a dynamic
/// stiffness test, ISO 10846-2:2008.
class Inertia final : public ParallelElement {
 public:
  explicit Inertia(double mass /* m [kg] */) : mass_(mass) {}

  std::size_t memorySize() const override { return 4; }
  double rest(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::elastic; }
  bool onRig() const override { return true; }
  std::optional<std::complex<double>> complexStiffness(double omega) const override { return -mass_ * omega * omega; }

 private:
  double mass_;
};

ElementType inertiaType();

}  // namespace rubber_suspension
