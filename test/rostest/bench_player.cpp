// Plays logs sample by sample, with the last value held, repeatedly and at a rate, for one and for several components.
#include "ros_interface/bench_player.h"

#include <gmock/gmock.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <cmath>
#include <filesystem>
#include <future>

#include "bench.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr const char* kLeft = "left_secondary";
constexpr const char* kRight = "right_secondary";

// Returns a log that begins 1000 s after the previous one, so that no sample is refused for a step back.
log::Log sineLog(int samples, std::int64_t interval) {
  static std::int64_t start = kStart;
  start += 1000 * 1000 * kMillisecond;
  log::Log log;
  log.name = "sine";
  for (int i = 0; i < samples; ++i) {
    log.stamp.push_back(start + i * interval);
    log.displacement.push_back(1e-3 * std::sin(0.1 * i));
    log.force.push_back(4e3 * std::sin(0.1 * i + 0.1));
  }
  return log;
}

ros_interface::BenchTrack track(const std::string& component, const log::Log& log) {
  ros_interface::BenchTrack track;
  track.component = component;
  track.log = log;
  return track;
}

TEST(BenchPlayer, StepsAndHolds) {
  constexpr std::size_t kStep = 3;
  constexpr std::size_t kSamples = 20;
  Bench bench(kLeft);
  ASSERT_TRUE(bench.connect());
  ros_interface::PlayControl control(kStep, true);
  const ros_interface::PlayControlServices services(ros::NodeHandle("~"), control);
  ros_interface::PlayOptions options;
  options.control = &control;
  ros_interface::BenchPlayer player(ros::NodeHandle(), options, {track(kLeft, sineLog(kSamples, kMillisecond))});
  auto played = std::async(std::launch::async, [&] { return player.play(1); });
  const std::shared_ptr<void> ends_play_on_failure(nullptr, [&](void*) { control.pause(false); });
  for (std::size_t steps = 1; steps <= 3; ++steps) {
    std_srvs::Trigger step;
    ASSERT_TRUE(ros_interface::callService(ros::names::resolve("~step"), step));
    ASSERT_TRUE(bench.waitForForces(steps * kStep));
    EXPECT_EQ(bench.forces.size(), steps * kStep);
  }
  std_srvs::SetBool let_go;
  let_go.request.data = false;
  ASSERT_TRUE(ros_interface::callService(ros::names::resolve("~pause"), let_go));
  const auto counts = played.get();
  EXPECT_EQ(counts.at(0).samples, kSamples);
  EXPECT_TRUE(counts.at(0).exactlyOneEach());
}

TEST(BenchPlayer, LoopsSeveralComponentsSideBySide) {
  constexpr std::size_t kPasses = 3;
  Bench left(kLeft);
  Bench right(kRight);
  ASSERT_TRUE(left.connect() && right.connect());
  const log::Log longer = sineLog(500, kMillisecond);
  const log::Log shorter = sineLog(200, 2 * kMillisecond);
  ros_interface::BenchPlayer player(ros::NodeHandle(), ros_interface::PlayOptions(),
                                    {track(kLeft, longer), track(kRight, shorter)});
  const auto counts = player.play(kPasses);
  EXPECT_EQ(counts.at(0).samples, kPasses * longer.size());
  EXPECT_EQ(counts.at(1).samples, kPasses * shorter.size());
  EXPECT_TRUE(counts.at(0).exactlyOneEach() && counts.at(1).exactlyOneEach());
  ASSERT_TRUE(left.waitForForces(kPasses * longer.size()));
  ASSERT_TRUE(right.waitForForces(kPasses * shorter.size()));
  // Both logs repeat with the duration of the longer log plus one of its time steps.
  const std::int64_t period = 500 * kMillisecond;
  for (std::size_t i = 0; i < right.forces.size(); ++i) {
    const std::int64_t expected =
        shorter.stamp[i % shorter.size()] + static_cast<std::int64_t>(i / shorter.size()) * period;
    ASSERT_EQ(static_cast<std::int64_t>(right.forces[i].header.stamp.toNSec()), expected);
  }
}

TEST(BenchPlayer, IsNeverFasterThanItsRate) {
  constexpr double kRate = 5.0;
  const log::Log log = sineLog(500, 2 * kMillisecond);
  ros_interface::PlayOptions options;
  options.rate = kRate;
  ros_interface::BenchPlayer player(ros::NodeHandle(), options, {track(kLeft, log)});
  const auto counts = player.play(1);
  EXPECT_TRUE(counts.at(0).exactlyOneEach());
  constexpr double kOnTime = 0.9;  // a first sample that is sent late shortens the measured duration
  EXPECT_GE(counts.at(0).duration, kOnTime * 1e-9 * static_cast<double>(log.stamp.back() - log.stamp.front()) / kRate);
}

// A header cannot contain negative stamps, so they are shifted by the same amount in every pass.
TEST(BenchPlayer, KeepsTheShiftOfNegativeTimes) {
  Bench bench(kLeft);
  ASSERT_TRUE(bench.connect());
  log::Log log = sineLog(100, kMillisecond);
  for (std::size_t i = 0; i < log.size(); ++i) {
    log.stamp[i] = (static_cast<std::int64_t>(i) - 50) * kMillisecond;
  }
  ros_interface::BenchPlayer player(ros::NodeHandle(), ros_interface::PlayOptions(), {track(kLeft, log)});
  EXPECT_TRUE(player.play(2).at(0).exactlyOneEach());
  ASSERT_TRUE(bench.waitForForces(200));
  EXPECT_EQ((bench.forces[100].header.stamp - bench.forces[0].header.stamp).toNSec(), 100 * kMillisecond);
}

TEST(BenchPlayer, RefusesWhatCannotBeWritten) {
  ros_interface::BenchTrack bad = track(kLeft, sineLog(10, kMillisecond));
  bad.paths = ros_interface::recordPathsIn(testing::TempDir() + "no_such_folder", kLeft);
  EXPECT_THROW(ros_interface::BenchPlayer(ros::NodeHandle(), ros_interface::PlayOptions(), {bad}), log::LogError);
}

// A misspelt component is reported from the node's list of components, long before the time limit for connecting.
TEST(BenchPlayer, ListsTheComponentsThatTheNodeHas) {
  ros_interface::PlayOptions options;
  options.connect_timeout = 10.0 * kPatience;
  ros_interface::BenchPlayer player(ros::NodeHandle(), options, {track("left_secondry", sineLog(10, kMillisecond))});
  const auto begin = std::chrono::steady_clock::now();
  const std::string message = messageOf<ros_interface::PlayError>([&] { player.connect(); });
  EXPECT_THAT(message,
              testing::HasSubstr("does not serve the component 'left_secondry' (did you mean 'left_secondary'?)"));
  EXPECT_THAT(message, testing::HasSubstr("accepted: left_secondary, right_secondary"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::duration<double>(options.connect_timeout / 2.0));
}

TEST(RecordPaths, PutNamespacesIntoTheName) {
  const ros_interface::RecordPaths paths = ros_interface::recordPathsIn("runs", "/front/left");
  EXPECT_EQ(paths.forces, "runs/front_left_force.csv");
  EXPECT_EQ(paths.gaps, "runs/front_left_gap.csv");
  EXPECT_EQ(paths.bag, "runs/front_left.bag");
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "bench_player"); }
