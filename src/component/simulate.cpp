// Many steps of equal length at once: the sums of Component::step, law after law over a block of samples, so that what
// the laws remember stays in registers. The same bits as step by step.
#include <algorithm>
#include <array>

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::component {
namespace {

// Samples. The Maxwell elements wait for their own last forces; the processor fills that time with what else there is
// to do for a block, if the block is short enough for it to see that.
constexpr std::size_t kSimulationBlock = 32;
constexpr std::size_t kMostMaxwells = kernel::MaxwellBlock::kSize;

// Steps of springs, dashpots, Maxwell elements and Berg friction alone.
struct PlainSteps {
  const double* displacement;
  std::size_t count;
  double* force;
  double start;  // displacement before the first step
  double spring_stiffness;
  double dashpot_gain;
  std::size_t maxwells;
  const kernel::MaxwellBlock* maxwell;
  double* maxwell_force;
  std::size_t bergs;
  const element::BergFriction* berg;
  double* berg_memory;
};

}  // namespace
}  // namespace rubber_suspension::component

#define RUBBER_SUSPENSION_LAYER component
#define RUBBER_SUSPENSION_KERNELS "kernel/simulate_kernels.h"
#include "kernel/instruction_sets.h"

namespace rubber_suspension::component {

void Component::simulate(ComponentState& state, double dt, const double* displacement, std::size_t count,
                         double* force) const {
  if (count == 0) {
    return;
  }
  if (dt != state.prepared_dt_) {
    prepare(state, dt);
  }
  if (!plain_) {
    simulateEffects(state, dt, displacement, count, force);
    return;
  }
  double* memory = state.memory_.data();
  RUBBER_SUSPENSION_KERNEL(simulatePlainSteps)
  ({displacement, count, force, state.displacement_, spring_stiffness_, state.dashpot_gain_, maxwells_,
    state.maxwell_blocks_.data(), memory, bergs_.size(), bergs_.data(), memory + maxwells_});
  state.branch_ = {};
  state.displacement_ = displacement[count - 1];
}

void Component::simulateEffects(ComponentState& state, double dt, const double* displacement, std::size_t count,
                                double* force) const {
  std::array<element::ComponentForce, kEffectBlock> forces;
  for (std::size_t first = 0; first < count; first += kEffectBlock) {
    const std::size_t size = std::min(kEffectBlock, count - first);
    stepsThroughEffects(state, dt, displacement + first, size, forces.data());
    std::transform(forces.begin(), forces.begin() + static_cast<std::ptrdiff_t>(size), force + first,
                   [](const element::ComponentForce& parts) { return parts.total; });
  }
}

}  // namespace rubber_suspension::component
