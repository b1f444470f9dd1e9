// Many steps of equal length at once: the sums of BasicLawsKernel::step, law after law over a block of samples, so that
// the memory of the laws stays in registers. The bits are the same as step by step.
#include "rubber_suspension/kernel/basic_laws_kernel.h"

namespace rubber_suspension::kernel {
namespace {

// Samples. The Maxwell elements wait for their own last forces; meanwhile the processor executes the other instructions
// of a block, if the block is short enough.
constexpr std::size_t kSimulationBlock = 32;
constexpr std::size_t kMostMaxwells = MaxwellBlock::kSize;

// The laws, and the samples over which they are stepped.
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
