// Many steps of equal length at once. Each law is simulated over a block of samples, so that its memory stays in
// registers. The forces equal those of BasicLawsKernel::step bit by bit.
#include "rubber_suspension/kernel/basic_laws_kernel.h"

namespace rubber_suspension::kernel {
namespace {

// Samples of a block. Each step of a Maxwell element waits for its preceding step. In the meantime the processor
// executes other instructions of the block, if the block is short enough.
constexpr std::size_t kSimulationBlock = 32;
constexpr std::size_t kMostMaxwells = MaxwellBlock::kSize;

// The laws, and the samples over which they are simulated.
struct LogSteps {
  const double* displacement;
  std::size_t count;
  double* force;
  double start;  // displacement before the first step
  double spring_stiffness;
  double dashpot_gain;
  std::size_t maxwells;
  const MaxwellBlock* maxwell;
  double* maxwell_force;
  std::size_t frictions;
  const element::BergFriction* friction;
  double* friction_memory;
};

}  // namespace
}  // namespace rubber_suspension::kernel

#define RUBBER_SUSPENSION_LAYER kernel
#define RUBBER_SUSPENSION_KERNELS "kernel/simulate_kernels.h"
#include "processor/instruction_sets.h"

namespace rubber_suspension::kernel {

void BasicLawsKernel::simulate(double dt, double start, const double* displacement, std::size_t count, double* force,
                               double* memory, PreparedStep& prepared) const {
  if (count == 0) {
    return;
  }
  if (dt != prepared.dt) {
    prepare(dt, prepared);
  }
  RUBBER_SUSPENSION_KERNEL(simulateLogSteps)
  ({displacement, count, force, start, spring_stiffness_, prepared.dashpot_gain, maxwell_count_,
    prepared.maxwells.data(), memory, frictions_.size(), frictions_.data(), frictionMemory(memory)});
  prepared.branch = {};
}

}  // namespace rubber_suspension::kernel
