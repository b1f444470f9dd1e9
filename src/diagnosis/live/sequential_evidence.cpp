// Evidence that grows block by block.
#include "diagnosis/live/sequential_evidence.h"

#include <algorithm>

namespace rubber_suspension::diagnosis {

void SequentialEvidence::add(bool won) {
  constexpr double kMost = 1e30;  // says no more than the threshold does, and stays finite
  value_ = std::min(kMost, std::max(value_, 1.0) * (won ? 1.0 + kBet : 1.0 - kBet));
}

}  // namespace rubber_suspension::diagnosis
