// Calls the version of each check for the instructions in use.
#include "kernel/sample_checks.h"

#define RUBBER_SUSPENSION_LAYER kernel
#define RUBBER_SUSPENSION_KERNELS "kernel/sample_checks_kernels.h"
#include "processor/instruction_sets.h"

namespace rubber_suspension::kernel {

bool allFinite(const double* value, std::size_t count) {
  return RUBBER_SUSPENSION_KERNEL(exponentsBelow)(value, count, 2047);
}

bool allBelowTwoTo(unsigned power, const double* value, std::size_t count) {
  return RUBBER_SUSPENSION_KERNEL(exponentsBelow)(value, count, 1023U + power);
}

bool allIncreasing(const std::int64_t* stamp, std::size_t count) {
  return RUBBER_SUSPENSION_KERNEL(increasing)(stamp, count);
}

bool allEven(const std::int64_t* stamp, std::size_t count, std::uint64_t step) {
  return count == 0 || RUBBER_SUSPENSION_KERNEL(even)(stamp, count, step);
}

}  // namespace rubber_suspension::kernel
