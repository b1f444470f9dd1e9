// The numbers of the judgement as fitted last.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers;
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
