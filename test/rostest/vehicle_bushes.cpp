// A body on four bushes is stepped with the running node over the topics `poses` and `wrenches`. Its wrenches equal
// those of the library to the last bit.
#include <cmath>

#include "apps/topic_exchange.h"
#include "bench.h"

namespace rubber_suspension::vehicle {
namespace {

Scene someTrack() {
  log::Log log;
  log.name = "track";
  for (int i = 0; i <= 1000; ++i) {
    const double t = 1e-3 * i;
    log.stamp.push_back(i * 1000000LL);
    log.displacement.push_back(std::min(1.0, 4.0 * t * t) * (2e-3 * std::sin(9.0 * t) + 1e-3 * std::sin(41.0 * t)));
  }
  Scene scene;
  scene.kind = Kind::body;
  scene.track = Track(log);
  scene.duration = 1.0;
  scene.step = 500000;
  return scene;
}

class VehicleBushes : public testing::TestWithParam<int> {};

TEST_P(VehicleBushes, GiveTheWrenchesOfTheLibraryToTheLastBit) {
  const Bushes components = loadBushes(Kind::body, ros::NodeHandle("~").param<std::string>("config_file", ""));
  LibraryExchange library(components);
  const History expected = runExchange(someTrack(), library, GetParam());
  PoseExchange topics(Kind::body, "/simulate/reset");
  const History loop = runExchange(someTrack(), topics, GetParam());
  ASSERT_EQ(loop.size(), expected.size());
  ASSERT_EQ(loop.size(), 2001U);
  double largest = 0.0;
  for (std::size_t n = 0; n < loop.size(); ++n) {
    for (std::size_t i = 0; i < components.size(); ++i) {
      ASSERT_EQ(loop.pose[n][i].matrix(), expected.pose[n][i].matrix()) << "step " << n;
      ASSERT_EQ(loop.wrench[n][i].force, expected.wrench[n][i].force) << "step " << n;
      ASSERT_EQ(loop.wrench[n][i].moment, expected.wrench[n][i].moment) << "step " << n;
      largest = std::max(largest, loop.wrench[n][i].force.norm());
    }
  }
  EXPECT_GT(largest, 50.0);  // [N]
}

INSTANTIATE_TEST_SUITE_P(StepsOfDelay, VehicleBushes, testing::Values(0, 1));

}  // namespace
}  // namespace rubber_suspension::vehicle

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "vehicle_bushes"); }
