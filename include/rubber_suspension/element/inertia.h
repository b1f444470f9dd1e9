// Mass that moves with the actuator: fixture, load cell, or the rubber's own share. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// F = m d2z/dt2, K* = -m w^2: lowers the measured stiffness as f^2, in phase.
/// Without a bandwidth the acceleration at a sample is extrapolated linearly from the second differences of the last
/// four samples, exact for a cubic z(t) at any step lengths, so that the force is neither late nor lossy: relative
/// error 11/12 (w dt)^2 under a sine. Noise of standard deviation s on z makes about 6.8 m s/dt^2 of noise on F. A kink
/// of z(t) gives a pulse of force over three steps. Memory: velocity and second difference of the step before, and the
/// last two step lengths (0 after a rest). Source: fixture mass of a dynamic stiffness test, ISO 10846-2:2008.
class Inertia final : public ParallelElement {
 public:
  explicit Inertia(double mass /* m [kg] */) : mass_(mass) {}

  std::size_t memorySize() const override { return 4; }
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::elastic; }
  bool onRig() const override { return true; }
  bool passive() const override { return false; }
  std::optional<std::complex<double>> complexStiffness(double omega) const override { return -mass_ * omega * omega; }

 private:
  double mass_;
};

/// The same of a noisy displacement: F = m d2z/dt2 of z behind the filter H(s) = (1 + 4 s/w_b)/(1 + s/w_b)^4, whose
/// error 6 (w/w_b)^2 has no part of first order, so that the force is not late at low frequency. White noise s on z
/// makes 0.87 m s/dt^2 of force at w_b dt = 1, beyond which samples are too far apart for the filter, and 0.041 m
/// s/dt^2 at w_b dt = 1/4. The filter is stepped exactly for a displacement that is linear between samples, at any step
/// lengths. Memory: what the four lags lag by. Source: observer form of a filtered differentiator, e.g. Khalil,
/// Nonlinear Systems (2002), section 14.5.
class SmoothedInertia final : public ParallelElement {
 public:
  SmoothedInertia(double mass /* m [kg] */, double bandwidth /* w_b/(2 pi) [Hz] */);

  std::size_t memorySize() const override { return kLags; }
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::elastic; }
  bool onRig() const override { return true; }
  bool passive() const override { return false; }
  std::optional<std::complex<double>> complexStiffness(double omega) const override;

 private:
  static constexpr std::size_t kLags = 4;

  double mass_;
  double rate_;  // w_b [rad/s]
};

ElementType inertiaType();

}  // namespace rubber_suspension::element
