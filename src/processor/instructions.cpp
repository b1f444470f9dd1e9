// Detects the vector instructions of this processor.
#include "rubber_suspension/processor/instructions.h"

#include <algorithm>
#include <atomic>

namespace rubber_suspension::processor {
namespace {

Instructions widest() {
// On Windows the stack is aligned to 16 bytes, and GCC may spill vectors of 32 bytes to it (GCC bug 54412).
#if defined(__x86_64__) && !defined(_WIN32)
  if (__builtin_cpu_supports("avx512f") != 0) {
    return Instructions::avx512;
  }
  if (__builtin_cpu_supports("avx2") != 0) {
    return Instructions::avx2;
  }
#endif
  return Instructions::any;
}

std::atomic<Instructions>& inUse() {
  static std::atomic<Instructions> instructions = widest();
  return instructions;
}

}  // namespace

Instructions instructionsInUse() { return inUse().load(std::memory_order_relaxed); }

void useAtMost(Instructions most) { inUse().store(std::min(most, widest()), std::memory_order_relaxed); }

}  // namespace rubber_suspension::processor
