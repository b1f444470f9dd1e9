// A log gives the same forces to the last bit through the node, from a CSV file, from a bag, and by `replay`.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "bag/bag_log.h"
#include "bench.h"
#include "ros_interface/log_player.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension {
namespace {

class ReplayEqualsLive : public testing::TestWithParam<std::string> {
 protected:
  std::string configFile() const { return ros::NodeHandle("~").param<std::string>("config_file", ""); }
  std::string path(const std::string& end) const { return testing::TempDir() + "live_" + GetParam() + end; }
};

// Returns a random motion with uneven steps and one time gap longer than max_gap, from a fixed seed.
log::Log unevenLog(double start) {
  std::mt19937 random(20151);
  std::normal_distribution<double> kick(0.0, 2e-4);
  std::uniform_int_distribution<std::int64_t> step(100, 3000000);
  log::Log log;
  log.name = "uneven";
  std::int64_t stamp = static_cast<std::int64_t>(start * 1e9);
  double displacement = 1e-3;
  for (int i = 0; i < 20000; ++i) {
    stamp += i == 7000 ? 2000000000LL : step(random);
    displacement = 0.99 * displacement + kick(random);
    log.stamp.push_back(stamp);
    log.displacement.push_back(displacement);
  }
  return log;
}

std::vector<double> live(const std::string& component, const log::Log& log) {
  ros_interface::PlayOptions options;
  options.component = component;
  ros_interface::LogPlayer player(ros::NodeHandle(), options);
  const ros_interface::PlayResult result = player.play(log);
  EXPECT_TRUE(result.exactlyOneEach()) << result.answered() << " of " << log.size() << " answered";
  std::vector<double> force;
  for (const element::ComponentForce& answer : result.force) {
    force.push_back(answer.total);
  }
  return force;
}

void expectSame(const std::vector<double>& expected, const std::vector<double>& actual) {
  ASSERT_EQ(expected.size(), actual.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(expected[i], actual[i]) << "sample " << i;
  }
}

TEST_P(ReplayEqualsLive, ToTheLastBit) {
  const auto components = io::loadComponentFile(configFile());
  const component::Component component = io::selectComponent(components, GetParam()).makeComponent();
  const log::Log log = unevenLog(100.0);
  expectSame(gap::replay(component, log).force, live(GetParam(), log));
}

// These logs start before the log above. The node sees a step back of more than a second, and starts again.
TEST_P(ReplayEqualsLive, ThroughCsvAndBag) {
  const auto components = io::loadComponentFile(configFile());
  const component::Component component = io::selectComponent(components, GetParam()).makeComponent();
  const log::Log log = unevenLog(50.0);
  const std::vector<double> expected = gap::replay(component, log).force;
  log::writeLogCsv(path(".csv"), log);
  bag::writeBagLog(path(".bag"), GetParam(), log);
  expectSame(expected, live(GetParam(), bag::readAnyLog(path(".csv"))));
  expectSame(expected, live(GetParam(), bag::readAnyLog(path(".bag"), GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Components, ReplayEqualsLive, testing::Values("left_secondary", "right_secondary"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "replay_equals_live"); }
