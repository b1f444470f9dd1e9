// Tests that run once for each kind of instructions.
#pragma once

#include "rubber_suspension/processor/instructions.h"
#include "support/test.h"

namespace rubber_suspension::test {

/// All kinds of instructions that this processor has, one after the other.
class OnAnyProcessor : public testing::TestWithParam<processor::Instructions> {
 protected:
  OnAnyProcessor() { processor::useAtMost(GetParam()); }
  ~OnAnyProcessor() override { processor::useAtMost(processor::Instructions::avx512); }
};

inline auto anyInstructions() {
  return testing::Values(processor::Instructions::any, processor::Instructions::avx2, processor::Instructions::avx512);
}

}  // namespace rubber_suspension::test
