// Linear dashpot.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension {

/// F = c dz/dt, the rate being that of the piecewise linear displacement: the force of a sampled sine lags by half a
/// step, an error of phase of pi f dt. Its stiffness grows without limit with frequency, so it suits a narrow band
/// only. Source: Polach (IAVSD 2015), element c0 of M1, M3 and M5.
class Dashpot final : public ParallelElement {
 public:
  explicit Dashpot(double damping /* [N s/m] */) : damping_(damping) {}

  double damping() const { return damping_; }

  double rest(double /*displacement*/, double* /*memory*/) const override { return 0.0; }
  double step(const Motion& motion, double* /*memory*/) const override {
    return damping_ * (motion.increment / motion.dt);
  }
  Part part() const override { return Part::viscous; }
  std::optional<std::complex<double>> complexStiffness(double omega) const override {
    return std::complex<double>(0.0, omega * damping_);
  }

 private:
  double damping_;
};

ElementType dashpotType();

}  // namespace rubber_suspension
