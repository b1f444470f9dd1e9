// Linear dashpot. Its make() throws std::invalid_argument for an order other than 1 or 2.
#pragma once

#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/smooth_rate.h"

namespace rubber_suspension::element {

/// F = c dz/dt, the rate being that of the piecewise linear displacement: the force of a sampled sine lags by half a
/// step, an error of phase of pi f dt. Its stiffness grows without limit with frequency, so it suits a narrow band
/// only. Source: Polach (IAVSD 2015), element c0 of M1, M3 and M5.
class Dashpot final : public ParallelElement {
 public:
  explicit Dashpot(double damping /* [N s/m] */) : damping_(damping) {}

  double damping() const { return damping_; }

  double initialise(double /*displacement*/, double* /*memory*/) const override { return 0.0; }
  double step(const Motion& motion, double* /*memory*/) const override {
    return damping_ * (motion.increment / motion.dt);
  }
  Part part() const override { return Part::viscous; }
  bool addTo(BasicLaws& sum) const override {
    sum.damping += damping_;
    return true;
  }
  std::optional<std::complex<double>> complexStiffness(double omega) const override {
    return std::complex<double>(0.0, omega * damping_);
  }

 private:
  double damping_;
};

/// F = c dz/dt for a displacement that is smooth between samples: without lag.
class SmoothDashpot final : public SmoothRateDashpot {
 public:
  explicit SmoothDashpot(double damping /* [N s/m] */) : damping_(damping) {}

  double step(const Motion& motion, double* memory) const override { return damping_ * rateAfter(motion, memory); }
  std::optional<std::complex<double>> complexStiffness(double omega) const override {
    return std::complex<double>(0.0, omega * damping_);
  }

 private:
  double damping_;
};

ElementType dashpotType();

}  // namespace rubber_suspension::element
