// Mass that moves with the actuator: fixture, load cell, or a share of the rubber's mass.
#include <cmath>

#include "element/registry.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::element {
namespace {

enum InertiaSlot { kVelocity, kAcceleration, kLastStep, kStepBeforeLast };

/// Simulates F = m d2z/dt2, K* = -m w^2. The law lowers the measured storage stiffness in proportion to f^2 and has no
/// loss.
/// Without a bandwidth the acceleration at a sample is extrapolated linearly from the second differences of the last
/// four samples, exactly for a cubic z(t) at any step lengths, so that the force has neither lag nor loss. Its relative
/// error is 11/12 (w dt)^2 under a sine. Noise of standard deviation s on z causes about 6.8 m s/dt^2 of noise on F. A
/// kink of z(t) causes a pulse of force over three steps. Memory: velocity and second difference of the last step, and
/// the last two step lengths (0 after a rest). Source: fixture mass of a dynamic stiffness test, ISO 10846-2:2008.
class Inertia final : public ParallelElement {
 public:
  explicit Inertia(double mass /* m [kg] */) : mass_(mass) {}

  std::size_t memorySize() const override { return 4; }
  double step(const Motion& motion, double* memory) const override {
    // During a rest the displacement is constant, so its steps may have any length.
    const double dt1 = motion.dt;
    const double dt2 = memory[kLastStep] > 0.0 ? memory[kLastStep] : dt1;
    const double dt3 = memory[kStepBeforeLast] > 0.0 ? memory[kStepBeforeLast] : dt2;
    const double velocity = motion.increment / dt1;
    // For a cubic, a second difference is the acceleration at the mean time of its three samples.
    const double acceleration = (velocity - memory[kVelocity]) / (0.5 * (dt1 + dt2));
    const double ahead = (2.0 * dt1 + dt2) / (dt1 + dt2 + dt3);
    const double extrapolated = acceleration + ahead * (acceleration - memory[kAcceleration]);
    memory[kVelocity] = velocity;
    memory[kAcceleration] = acceleration;
    memory[kStepBeforeLast] = dt2;
    memory[kLastStep] = dt1;
    return mass_ * extrapolated;
  }
  Part part() const override { return Part::elastic; }
  bool onRig() const override { return true; }
  bool passive() const override { return false; }
  std::optional<std::complex<double>> complexStiffness(double omega) const override { return -mass_ * omega * omega; }

 private:
  double mass_;
};

/// Simulates F = m d2z/dt2 for a noisy displacement, with z filtered by H(s) = (1 + 4 s/w_b)/(1 + s/w_b)^4. The error
/// of H is 6 (w/w_b)^2, without a term of first order, so the force has no lag at low frequency. White noise of
/// standard deviation s on z causes noise of 0.87 m s/dt^2 on F at w_b dt = 1 and of 0.041 m s/dt^2 at w_b dt = 1/4.
/// For w_b dt > 1 the samples are too far apart for the filter. The filter is stepped exactly for a displacement that
/// is linear between samples, at any step lengths. Memory: the outputs of four first-order filters relative to z.
/// Source: observer form of a filtered differentiator, e.g. Khalil, Nonlinear Systems (2002), section 14.5.
class SmoothedInertia final : public ParallelElement {
 public:
  SmoothedInertia(double mass /* m [kg] */, double bandwidth /* w_b/(2 pi) [Hz] */)
      : mass_(mass), rate_(2.0 * kPi * bandwidth) {}

  std::size_t memorySize() const override { return kLags; }

  // First-order filters in series, y_k' = w_b (y_(k-1) - y_k), y_0 = z. Under a ramp of slope v, y_k - z tends to -k
  // v/w_b. The deviation from this limit decays as exp(-w_b t) times a polynomial, whose coefficients depend on the
  // deviations of y_1 to y_k. The memory contains y_k - z, which is 0 at rest.
  double step(const Motion& motion, double* memory) const override {
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
    // This is s^2 H(s) z in terms of the outputs of the filters, because s/w_b = (1 - L)/L with L = 1/(1 + s/w_b).
    const double bend = 4.0 * memory[0] - 11.0 * memory[1] + 10.0 * memory[2] - 3.0 * memory[3];
    return mass_ * rate_ * rate_ * bend;
  }
  Part part() const override { return Part::elastic; }
  bool onRig() const override { return true; }
  bool passive() const override { return false; }
  std::optional<std::complex<double>> complexStiffness(double omega) const override {
    const std::complex<double> s(0.0, omega / rate_);
    return -mass_ * omega * omega * (1.0 + 4.0 * s) / std::pow(1.0 + s, 4);
  }

 private:
  static constexpr std::size_t kLags = 4;

  double mass_;
  double rate_;  // w_b [rad/s]
};

const ElementEntry kInertiaEntry(
    430, {"inertia",
          "Mass that moves with the actuator: F = m d2z/dt2.",
          {{"mass", "kg", Role::scale, Range::positive(), "moving mass m between load cell and test piece"},
           {"bandwidth", "Hz", Role::choice, Range::nonNegative(),
            "bandwidth of a filter for noisy displacements; 0 (for smooth displacements): no filter", 0.0}},
          [](const ElementDescription& description) -> ElementPointer {
            const double mass = description.value("mass");
            const double bandwidth = description.value("bandwidth");
            if (bandwidth > 0.0) {
              return std::make_shared<const SmoothedInertia>(mass, bandwidth);
            }
            return std::make_shared<const Inertia>(mass);
          }});

}  // namespace
}  // namespace rubber_suspension::element
