// Tests the temperature topic: the node applies temperatures by their stamps, equal to `replay` to the last bit.
#include <sensor_msgs/Temperature.h>

#include <cmath>

#include "bench.h"
#include "ros_interface/log_player.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension {
namespace {

// Returns 20 s of motion at 50 Hz with a measured temperature in every tenth sample.
log::Log warmingLog() {
  log::Log log;
  log.name = "warming";
  double temperature = 0.0;
  for (int i = 0; i < 1000; ++i) {
    temperature = i % 10 == 0 ? 15.0 + 0.03 * i : temperature;
    log.stamp.push_back(kStart + i * 20 * kMillisecond);
    log.displacement.push_back(1e-3 * std::sin(0.7 * i) + 5e-4 * std::sin(0.031 * i));
    log.temperature.push_back(temperature);
  }
  return log;
}

TEST(TemperatureTopic, FollowsTheStampsAsReplayDoes) {
  const log::Log log = warmingLog();
  Bench bench("bush");
  ros::NodeHandle handle;
  ros::Publisher publisher = handle.advertise<sensor_msgs::Temperature>("bush/temperature", 1000);
  DiagnosticsWatch diagnostics;
  ASSERT_TRUE(bench.connect());
  ASSERT_TRUE(spinUntil([&] { return publisher.getNumSubscribers() > 0; }));
  const auto send = [&](std::int64_t stamp, double temperature) {
    sensor_msgs::Temperature message;
    message.header.stamp = bag::toRosTime(stamp);
    message.temperature = temperature;
    publisher.publish(message);
  };
  for (std::size_t i = 0; i < log.size(); i += 10) {
    send(log.stamp[i], log.temperature[i]);
  }
  // Messages of one connection arrive in order. Once these two are refused, all earlier temperatures have arrived.
  send(log.stamp.back(), std::nan(""));
  send(log.stamp.back(), -250.0);
  ASSERT_TRUE(diagnostics.waitForCount("bush", "temperatures, refused", 2));

  const auto components = io::loadComponentFile(ros::NodeHandle("~").param<std::string>("config_file", ""));
  const component::Component component = components.at(0).makeComponent();
  const std::vector<double> expected = gap::simulateLog(component, log);
  for (std::size_t i = 0; i < log.size(); ++i) {
    ASSERT_EQ(bench.ask(log.stamp[i], log.displacement[i]).force, expected[i]) << "sample " << i;
  }
  log::Log without = log;
  without.temperature.clear();
  EXPECT_NE(gap::simulateLog(component, without).back(), expected.back()) << "the temperature does nothing";
  EXPECT_TRUE(spinUntil([&] { return diagnostics.value("bush", "temperature [degC]") == "44.7"; }));
}

// The log has more changes of temperature than the node can store in advance.
TEST(TemperatureTopic, APlayedLogHasTheForcesOfItsReplay) {
  log::Log log;
  log.name = "long";
  for (int i = 0; i < 5000; ++i) {
    log.stamp.push_back(kStart + i * kMillisecond);
    log.displacement.push_back(1e-3 * std::sin(0.05 * i));
    log.temperature.push_back(30.0 - 0.002 * i);
  }
  ros_interface::PlayOptions options;
  options.component = "bush";
  ros_interface::LogPlayer player(ros::NodeHandle(), options);
  const ros_interface::PlayResult played = player.play(log);
  ASSERT_TRUE(played.exactlyOneEach());
  const auto components = io::loadComponentFile(ros::NodeHandle("~").param<std::string>("config_file", ""));
  const std::vector<double> expected = gap::simulateLog(components.at(0).makeComponent(), log);
  for (std::size_t i = 0; i < log.size(); ++i) {
    ASSERT_EQ(played.force[i].total, expected[i]) << "sample " << i;
  }
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "temperature"); }
