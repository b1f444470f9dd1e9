// What logs count for whose force is little more than noise.
#include <gtest/gtest.h>

#include <vector>

#include "measurement/rig_noise.h"

namespace rubber_suspension {
namespace {

TEST(NoisyLog, CountsAsIfItHadAcceptedNoise) {
  std::vector<log::Record> records(3);
  measurement::weighByNoise({0.01, 0.02, 0.2}, 0.02, records);
  EXPECT_DOUBLE_EQ(records[0].weight, records[1].weight);
  EXPECT_NEAR(records[2].weight / records[0].weight, 0.01, 1e-12);  // (0.02/0.2)^2
  EXPECT_NEAR(records[0].weight + records[1].weight + records[2].weight, 3.0, 1e-12);
}

TEST(NoisyLog, CountsAsOthersDoWhereAllAre) {
  std::vector<log::Record> records(3);
  measurement::weighByNoise({0.1, 0.1, 0.1}, 0.02, records);
  for (const log::Record& record : records) {
    EXPECT_DOUBLE_EQ(record.weight, 1.0);
    EXPECT_TRUE(record.notes.empty());
  }
}

}  // namespace
}  // namespace rubber_suspension
