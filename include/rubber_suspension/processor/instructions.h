// Vector instructions of the code that processes blocks of samples. No function here throws.
#pragma once

namespace rubber_suspension::processor {

/// Kinds of processors for which this code is compiled. The results are the same bit by bit.
enum class Instructions {
  any,     ///< instructions that every processor of the architecture has
  avx2,    ///< instructions for four numbers at once
  avx512,  ///< instructions for eight numbers at once
};

/// Returns the widest instructions of this processor, unless useAtMost() limits them.
Instructions instructionsInUse();

/// Limits the instructions of all threads from now on, for tests and to measure the speed of other processors.
void useAtMost(Instructions most);

}  // namespace rubber_suspension::processor
