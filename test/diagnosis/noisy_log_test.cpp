// Weights of logs whose force is little more than noise.
#include "measurement/rig_noise.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(NoisyLog, CountsAsIfItHadAcceptedNoise) {
  const std::vector<measurement::LogWeight> logs = measurement::weightsByNoise({0.01, 0.02, 0.2}, 0.02);
  ASSERT_EQ(logs.size(), 3U);
  EXPECT_DOUBLE_EQ(logs[0].weight, logs[1].weight);
  EXPECT_NEAR(logs[2].weight / logs[0].weight, 0.01, 1e-12);  // the square of 0.02/0.2
  EXPECT_NEAR(logs[0].weight + logs[1].weight + logs[2].weight, 3.0, 1e-12);
}

TEST(NoisyLog, CountsAsOthersDoWhereAllAre) {
  for (const measurement::LogWeight& log : measurement::weightsByNoise({0.1, 0.1, 0.1}, 0.02)) {
    EXPECT_DOUBLE_EQ(log.weight, 1.0);
    EXPECT_TRUE(log.note.empty());
  }
}

}  // namespace
}  // namespace rubber_suspension
