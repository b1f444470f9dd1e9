// Coefficients of dashpots and Maxwell elements for a step length.
#include "rubber_suspension/element/maxwell.h"
#include "rubber_suspension/kernel/basic_laws_kernel.h"

#define RUBBER_SUSPENSION_LAYER kernel
#define RUBBER_SUSPENSION_KERNELS "kernel/prepare_kernels.h"
#include "processor/instruction_sets.h"

namespace rubber_suspension::kernel {
namespace {

void setLarge(double ratio, double stiffness, std::size_t element, MaxwellBlock& block) {
  const element::MaxwellStep step(stiffness, element::Relaxation::large(ratio));
  block.decay[element / 2][element % 2] = step.decay;
  block.gain[element / 2][element % 2] = step.gain;
}

}  // namespace

void BasicLawsKernel::prepare(double dt, PreparedStep& prepared) const {
  // Computes all elements as for small steps, then replaces those for which the step is large.
  RUBBER_SUSPENSION_KERNEL(prepareSmall)
  (dt, maxwell_rate_.data(), maxwell_stiffness_.data(), maxwell_count_, prepared.maxwells.data());
  if (dt * fastest_rate_ > element::Relaxation::kSmall) {
    for (std::size_t i = 0; i < maxwell_count_; ++i) {
      const double ratio = dt * maxwell_rate_[i];
      if (ratio > element::Relaxation::kSmall) {
        setLarge(ratio, maxwell_stiffness_[i], i % MaxwellBlock::kSize, prepared.maxwells[i / MaxwellBlock::kSize]);
      }
    }
  }
  prepared.dashpot_gain = damping_ / dt;
  prepared.dt = dt;
}

}  // namespace rubber_suspension::kernel
