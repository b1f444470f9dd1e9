// Vector instructions of the code for blocks of samples. Throws nothing.
#pragma once

namespace rubber_suspension::processor {

/// Kinds of processors that such code is compiled for, each next to the others. All give the same bits.
enum class Instructions {
  any,     ///< what each processor of the architecture has
  avx2,    ///< four numbers at once
  avx512,  ///< eight numbers at once
};

/// The widest of the processor, unless limited by useAtMost().
Instructions instructionsInUse();

/// Use none wider than these from here on, in all threads: for tests, and to measure what other processors would do.
void useAtMost(Instructions most);

}  // namespace rubber_suspension::processor
