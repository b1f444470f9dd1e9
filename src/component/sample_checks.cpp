// The checks, each by the instructions in use.
#include "rubber_suspension/component/sample_checks.h"

#define RUBBER_SUSPENSION_KERNELS "sample_checks_kernels.h"
#include "instruction_sets.h"

namespace rubber_suspension {

bool allFinite(const double* value, std::size_t count) { return RUBBER_SUSPENSION_KERNEL(finite)(value, count); }

bool allIncreasing(const std::int64_t* stamp, std::size_t count) {
  return RUBBER_SUSPENSION_KERNEL(increasing)(stamp, count);
}

bool allEven(const std::int64_t* stamp, std::size_t count, std::uint64_t step) {
  return count == 0 || RUBBER_SUSPENSION_KERNEL(even)(stamp, count, step);
}

}  // namespace rubber_suspension
