// Log lines about faults that persist become rarer with time.
#include "node/report_pace.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(ReportPace, FallsFromALineASecondToOneAMinute) {
  node::ReportPace pace;
  int first_minute = 0;
  int day = 0;
  for (int second = 0; second < 86400; ++second) {
    const int line = pace.isDue(second) ? 1 : 0;
    first_minute += second < 60 ? line : 0;
    day += line;
  }
  EXPECT_EQ(first_minute, 6);  // at 0, 1, 3, 7, 15 and 31 s
  EXPECT_LE(day, 1440 + 6);
  EXPECT_GE(day, 1400);
}

TEST(ReportPace, NewFaultsAreSaidAtOnce) {
  node::ReportPace pace;
  for (int second = 0; second < 1000; ++second) {
    pace.isDue(second);
  }
  const double later = 1000.0 + node::ReportPace::kForgotten + 1.0;
  EXPECT_TRUE(pace.isDue(later));
  EXPECT_FALSE(pace.isDue(later + 0.5));
  EXPECT_TRUE(pace.isDue(later + 1.0));
}

}  // namespace
}  // namespace rubber_suspension
