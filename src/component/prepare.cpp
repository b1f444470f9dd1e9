// Coefficients of a component's dashpots and Maxwell elements for one step length.
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/relaxation.h"

#define RUBBER_SUSPENSION_LAYER component
#define RUBBER_SUSPENSION_KERNELS "kernel/prepare_kernels.h"
#include "kernel/instruction_sets.h"

namespace rubber_suspension::component {
namespace {

void setLarge(double ratio, double stiffness, std::size_t element, kernel::MaxwellBlock& block) {
  const element::MaxwellStep step(stiffness, element::Relaxation::large(ratio));
  block.decay[element / 2][element % 2] = step.decay;
  block.gain[element / 2][element % 2] = step.gain;
}

}  // namespace

void Component::prepare(ComponentState& state, double dt) const {
  // All as if the step were small, as that goes side by side; then those for which it is not.
  RUBBER_SUSPENSION_KERNEL(prepareSmall)
  (dt, maxwell_rate_.data(), maxwell_stiffness_.data(), maxwells_, state.maxwell_blocks_.data());
  if (dt * fastest_rate_ > element::Relaxation::kSmall) {
    for (std::size_t i = 0; i < maxwells_; ++i) {
      const double ratio = dt * maxwell_rate_[i];
      if (ratio > element::Relaxation::kSmall) {
        setLarge(ratio, maxwell_stiffness_[i], i % kernel::MaxwellBlock::kSize,
                 state.maxwell_blocks_[i / kernel::MaxwellBlock::kSize]);
      }
    }
  }
  state.dashpot_gain_ = dashpot_damping_ / dt;
  state.prepared_dt_ = dt;
}

}  // namespace rubber_suspension::component
