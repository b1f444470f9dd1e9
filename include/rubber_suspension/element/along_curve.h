// Maxwell elements, dashpots and sliders whose size follows the displacement: rubber under a preload. Their make()
// throws std::invalid_argument for lists that do not go together.
#pragma once

#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/position_table.h"
#include "rubber_suspension/element/slider_bank.h"

namespace rubber_suspension::element {

/// dF/dt = k(z) dz/dt - F/tau, tau = 1/(2 pi f_b), with a stiffness that is linear between points of the displacement
/// and constant beyond. With k in proportion to the slope of the static curve, small oscillations have a loss angle
/// that does not depend on the preload, as those of rubber. With U the integral of k over z and w = U(z) - F, the
/// energy is the integral of U - w from the point where U = w; it never grows by more than the work done where k > 0.
/// Exact for a displacement that is linear between samples: a step is split at the points. Memory: force. Validity: one
/// relaxation time at all preloads. Source: branch of a nonlinear elastic function, A. Ledesma et al., UM-MEAM-95-05
/// (1995), in structure.
///
/// With `growth` b the curve has two numbers in place of points: k(z) = k_r exp(b ((z/z_r)^2 - 1)) up to the one
/// displacement z_r, constant beyond; on the other `side` it is that at 0. So the elastic force grows exponentially
/// with strain, and relaxes alike from any. Source: quasi-linear viscoelasticity, Y. C. Fung, Biomechanics (Springer
/// 1981), ch. 7.
class MaxwellAlongCurve final : public ParallelElement {
 public:
  MaxwellAlongCurve(PositionTable stiffness /* k(z) [N/m] */, double break_frequency /* f_b [Hz] */);

  std::size_t memorySize() const override { return 1; }
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::viscous; }

 private:
  PositionTable stiffness_;
  double rate_;  // 1/tau [1/s]
};

/// F = c(z) dz/dt with a damping as above: the mean over the step. Source: as above.
class DashpotAlongCurve final : public ParallelElement {
 public:
  explicit DashpotAlongCurve(PositionTable damping /* c(z) [N s/m] */) : damping_(std::move(damping)) {}

  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::viscous; }

 private:
  PositionTable damping_;
};

/// The force of a bank of Jenkins sliders times a factor b(z) >= 0 as above. The bank slides at the same displacements
/// at every preload, and holds b times the force. The integral of b k (z - s) from the slider s is its energy, so it
/// dissipates as it slides. Source: sliders as SliderBank.
class SlidersAlongCurve final : public ParallelElement {
 public:
  SlidersAlongCurve(std::vector<JenkinsSlider> sliders, PositionTable factor /* b(z) [-] */)
      : bank_(std::move(sliders)), factor_(std::move(factor)) {}

  std::size_t memorySize() const override { return bank_.memorySize(); }
  double initialise(double displacement, double* memory) const override {
    return bank_.initialise(displacement, memory);
  }
  double step(const Motion& motion, double* memory) const override {
    return factor_.at(motion.displacement) * bank_.step(motion, memory);
  }
  Part part() const override { return Part::friction; }

 private:
  SliderBank bank_;
  PositionTable factor_;
};

ElementType maxwellAlongCurveType();
ElementType dashpotAlongCurveType();
ElementType slidersAlongCurveType();

}  // namespace rubber_suspension::element
