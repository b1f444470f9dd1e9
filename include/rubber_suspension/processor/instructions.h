// Vector instructions of the code for blocks of samples. Throws nothing.
#pragma once

namespace rubber_suspension::processor {

/// Kinds of processors for which such code is compiled. All give the same bits.
enum class Instructions {
  any,     ///< those of every processor of the architecture
  avx2,    ///< four numbers at once
  avx512,  ///< eight numbers at once
};

/// Returns the widest of the processor, unless limited by useAtMost().
Instructions instructionsInUse();

/// Limits the instructions from here on, in all threads: for tests, and to measure what other processors would do.
void useAtMost(Instructions most);

}  // namespace rubber_suspension::processor
