// The words for verdicts in reports and records.
#include "rubber_suspension/diagnosis/verdict.h"

#include "support/test.h"

namespace rubber_suspension::test {
namespace {

using diagnosis::Verdict;

TEST(Verdict, IsReadAsItIsWritten) {
  for (int i = 0; i <= static_cast<int>(Verdict::defect); ++i) {
    const auto verdict = static_cast<Verdict>(i);
    EXPECT_EQ(diagnosis::verdictOf(toString(verdict)), verdict);
  }
  EXPECT_EQ(toString(Verdict::parameter_error), "parameter_error");
  EXPECT_THROW(diagnosis::verdictOf("watching"), std::invalid_argument);
}

}  // namespace
}  // namespace rubber_suspension::test
