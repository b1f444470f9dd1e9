// Tests that run once per instruction set of the processor.
#pragma once

#include "rubber_suspension/processor/instructions.h"
#include "support/test.h"

namespace rubber_suspension::test {

/// Limits the instruction set to the parameter of the test.
class OnAnyProcessor : public testing::TestWithParam<processor::Instructions> {
 protected:
  OnAnyProcessor() { processor::useAtMost(GetParam()); }
  ~OnAnyProcessor() override { processor::useAtMost(processor::Instructions::avx512); }
};

inline auto anyInstructions() {
  return testing::Values(processor::Instructions::any, processor::Instructions::avx2, processor::Instructions::avx512);
}

}  // namespace rubber_suspension::test
