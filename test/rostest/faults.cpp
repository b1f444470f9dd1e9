// Faults in the stream of samples, with one test and one component each. Each accepted sample has one force, equal to
// that of an undisturbed stream. Dropped samples are counted on /diagnostics.
#include <rosgraph_msgs/Log.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <thread>

#include "bench.h"
#include "benchmark/latency/latency_benchmark.h"
#include "node_process.h"
#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension {
namespace {

constexpr std::int64_t kSecond = 1000 * kMillisecond;

double wave(std::int64_t stamp) {
  return 2e-3 * std::sin(2.0 * element::kPi * 4.0 * 1e-9 * static_cast<double>(stamp - kStart));
}

// Opens the component with the name of the test, and a model that computes the expected forces.
class Fault : public testing::Test {
 protected:
  void open(const std::string& name) {
    name_ = name;
    static const auto components = io::loadComponentFile(ros::NodeHandle("~").param<std::string>("config_file", ""));
    component_ = std::make_unique<component::Component>(io::selectComponent(components, name).makeComponent());
    expected_ = std::make_unique<component::SampleStream>(*component_);
    bench_ = std::make_unique<Bench>(name);
    ASSERT_TRUE(bench_->connect());
  }

  // Sends a sample that must be answered, and checks its force.
  void expectAnswer(std::int64_t stamp, double displacement) {
    const std::size_t before = bench_->forces.size();
    const Force force = bench_->ask(stamp, displacement);
    EXPECT_EQ(force.header.stamp, bag::toRosTime(stamp));
    EXPECT_EQ(force.force, expected_->push(stamp, displacement).force.total);
    EXPECT_TRUE(std::isfinite(force.force));
    EXPECT_EQ(bench_->forces.size(), before + 1);
  }

  void run(std::int64_t first, int count) {
    for (int i = 0; i < count; ++i) {
      expectAnswer(first + i * kMillisecond, wave(first + i * kMillisecond));
    }
  }

  // Sends samples with stamps at 10 kHz as fast as the node answers, with at most a thousand unanswered.
  void flood(std::int64_t first, int count) {
    constexpr std::size_t kUnderWay = 1000;
    const std::size_t before = bench_->forces.size();
    const auto stamp = [&](std::size_t i) { return first + static_cast<std::int64_t>(i) * kMillisecond / 10; };
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      ASSERT_TRUE(spinUntil([&] { return before + i < bench_->forces.size() + kUnderWay; }));
      bench_->send(stamp(i), wave(stamp(i)));
    }
    ASSERT_TRUE(bench_->waitForForces(before + static_cast<std::size_t>(count)));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      ASSERT_EQ(bench_->forces[before + i].force, expected_->push(stamp(i), wave(stamp(i))).force.total);
    }
  }

  // Checks the counters, which are published once per second. Counters that `expected` does not list must be zero.
  void expectCounts(std::map<std::string, long> expected) {
    for (const char* key : {"dropped", "dropped, not finite", "dropped, force not finite", "dropped, repeated stamp",
                            "dropped, stepped back", "dropped, disabled", "dropped, undecodable",
                            "forces not delivered", "lost before arrival", "restarts", "time gaps bridged"}) {
      expected.emplace(key, 0);
    }
    const long accepted = expected.at("accepted");
    ASSERT_TRUE(diagnostics_.waitForCount(name_, "accepted", accepted));
    for (const auto& [key, value] : expected) {
      EXPECT_TRUE(diagnostics_.waitForCount(name_, key, value));
    }
    EXPECT_EQ(bench_->forces.size(), static_cast<std::size_t>(accepted));
  }

  std::string name_;
  std::unique_ptr<component::Component> component_;
  std::unique_ptr<component::SampleStream> expected_;
  std::unique_ptr<Bench> bench_;
  DiagnosticsWatch diagnostics_;
};

TEST_F(Fault, NotFinite) {
  open("not_finite");
  run(kStart, 50);
  bench_->send(kStart + 50 * kMillisecond, std::numeric_limits<double>::quiet_NaN());
  bench_->send(kStart + 51 * kMillisecond, std::numeric_limits<double>::infinity());
  bench_->send(kStart + 52 * kMillisecond, -std::numeric_limits<double>::infinity());
  run(kStart + 53 * kMillisecond, 50);
  expectCounts({{"accepted", 100}, {"dropped", 3}, {"dropped, not finite", 3}});
}

TEST_F(Fault, RepeatedStamp) {
  open("repeated");
  run(kStart, 50);
  bench_->send(kStart + 49 * kMillisecond, 0.5);  // this displacement must not change the state
  bench_->send(kStart + 49 * kMillisecond, wave(kStart + 49 * kMillisecond));
  run(kStart + 50 * kMillisecond, 50);
  expectCounts({{"accepted", 100}, {"dropped", 2}, {"dropped, repeated stamp", 2}});
}

TEST_F(Fault, StepBack) {
  open("stepped_back");
  run(kStart, 50);
  bench_->send(kStart + 48 * kMillisecond, 0.5);
  bench_->send(kStart + 49 * kMillisecond - kSecond, 0.5);  // a step back of at most one second is no new replay
  run(kStart + 50 * kMillisecond, 50);
  expectCounts({{"accepted", 100}, {"dropped", 2}, {"dropped, stepped back", 2}});
}

TEST_F(Fault, ClockResetByARestartedBag) {
  open("clock_reset");
  run(kStart + 100 * kSecond, 50);
  run(kStart, 50);  // both the component and the expected stream restart
  expectCounts({{"accepted", 100}, {"restarts", 1}});
}

TEST_F(Fault, BagLooped) {
  open("looped");
  constexpr int kLoops = 3;
  std::vector<double> first;
  for (int loop = 0; loop < kLoops; ++loop) {
    for (int i = 0; i < 60; ++i) {
      expectAnswer(kStart + i * 20 * kMillisecond, wave(kStart + i * 17 * kMillisecond));
      if (loop == 0) {
        first.push_back(bench_->forces.back().force);
      } else {
        EXPECT_EQ(bench_->forces.back().force, first[static_cast<std::size_t>(i)]);
      }
    }
  }
  expectCounts({{"accepted", 180}, {"restarts", 2}});
}

TEST_F(Fault, Gap) {
  open("gap");
  run(kStart, 50);
  expectAnswer(kStart + 10 * kSecond, 1e-3);
  run(kStart + 10 * kSecond + kMillisecond, 49);
  expectCounts({{"accepted", 100}, {"time gaps bridged", 1}});
}

TEST_F(Fault, Burst) {
  open("burst");
  constexpr int kBurst = 5000;  // sent at once, but fewer than fit into the queue of the node (10000)
  for (int i = 0; i < kBurst; ++i) {
    bench_->send(kStart + i * kMillisecond, wave(kStart + i * kMillisecond));
  }
  ASSERT_TRUE(bench_->waitForForces(kBurst));
  for (int i = 0; i < kBurst; ++i) {
    const std::int64_t stamp = kStart + i * kMillisecond;
    ASSERT_EQ(bench_->forces[static_cast<std::size_t>(i)].force, expected_->push(stamp, wave(stamp)).force.total);
  }
  expectCounts({{"accepted", kBurst}});
}

// The samples have stamps at 10 kHz over three seconds, and are sent as fast as the node answers.
TEST_F(Fault, FloodOfTenKilohertz) {
  open("flood");
  flood(kStart, 30000);
  expectCounts({{"accepted", 30000}});
}

// The name is legal in ROS, although other parsers might refuse it.
TEST_F(Fault, OddName) {
  open("Q_9__z_");
  run(kStart, 100);
  expectCounts({{"accepted", 100}});
}

// The node must not log a line for each of 2000 bad samples per second.
TEST_F(Fault, LogsOneLineASecondAtMost) {
  open("logged");
  std::size_t lines = 0;
  ros::NodeHandle handle;
  const ros::Subscriber log =
      handle.subscribe<rosgraph_msgs::Log>("/rosout", 10000, [&](const rosgraph_msgs::Log::ConstPtr& line) {
        lines += line->name == "/simulate" && line->msg.find("logged: ") != std::string::npos ? 1 : 0;
      });
  ASSERT_TRUE(spinUntil([&] { return ros_interface::sendsToThisNode("/simulate", "/rosout"); }));
  ASSERT_TRUE(spinUntil([&] { return diagnostics_.arrays > 0; }));
  const std::size_t before = diagnostics_.arrays;
  long sent = 0;
  while (diagnostics_.arrays < before + 3) {  // one array per second
    for (int i = 0; i < 20; ++i, ++sent) {
      bench_->send(kStart + sent, std::numeric_limits<double>::quiet_NaN());
    }
    // Five seconds of these samples fit into the queue of the node.
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
  expectCounts({{"accepted", 0}, {"dropped", sent}, {"dropped, not finite", sent}});
  EXPECT_GT(lines, 0U);
  EXPECT_LE(lines, diagnostics_.arrays - before + 1);
}

// A subscriber that does not read its socket must not delay others, and the node must limit its backlog.
TEST_F(Fault, SubscriberThatStalls) {
  open("stalled");
  const StalledSubscriber<Force> stalled("/simulate", "/stalled/force");
  ASSERT_TRUE(stalled.connected());
  const pid_t node = processOf("/simulate");
  ASSERT_GT(node, 0);
  constexpr int kFill = 100000;  // more than fits into the subscriber's queue (40000) and the sockets
  constexpr int kMore = 40000;
  constexpr long kWire = 64;  // bytes, more than a force takes on the wire
  flood(kStart, kFill);
  const long full = benchmark::residentMemory(node);
  flood(kStart + kFill * kMillisecond / 10, kMore);
  // If the node kept all unread forces, its memory would grow by more than this, because each force occupies a block of
  // its own, with pointers to it.
  EXPECT_LT(benchmark::residentMemory(node) - full, kWire * kMore);
  // The subscriber has indeed stalled: its socket buffer contains only a part of what was sent.
  EXPECT_LT(stalled.unread(), kWire * kFill);
  // Undelivered forces are counted, except those that still wait in the queue and in the sockets.
  EXPECT_TRUE(diagnostics_.waitForCount(name_, "accepted", kFill + kMore));
  const long missed = diagnostics_.count(name_, "forces not delivered");
  EXPECT_GT(missed, 0);
  EXPECT_LT(missed, kFill + kMore - 40000);
  expectCounts({{"accepted", kFill + kMore}, {"forces not delivered", missed}});
}

TEST_F(Fault, PublisherThatComesAndGoes) {
  open("comes_and_goes");
  run(kStart, 20);
  for (int visit = 1; visit <= 3; ++visit) {
    bench_.reset();
    bench_ = std::make_unique<Bench>("comes_and_goes");
    ASSERT_TRUE(bench_->connect());
    run(kStart + visit * 20 * kMillisecond, 20);
    ASSERT_EQ(bench_->forces.size(), 20U);
  }
  EXPECT_TRUE(diagnostics_.waitForCount("comes_and_goes", "accepted", 80));
  EXPECT_EQ(diagnostics_.count("comes_and_goes", "dropped"), 0);
  EXPECT_EQ(diagnostics_.count("comes_and_goes", "lost before arrival"), 0);
}

// The second publisher is a process that relays what it receives. The two take turns, then the second one is late.
TEST_F(Fault, TwoPublishersOnOneTopic) {
  open("two_publishers");
  Bench second("relay");
  ASSERT_TRUE(spinUntil([&] { return second.isHeard(); }));
  for (int i = 0; i < 100; ++i) {
    const std::int64_t stamp = kStart + i * kMillisecond;
    if (i % 2 == 0) {
      expectAnswer(stamp, wave(stamp));
      continue;
    }
    second.send(stamp, wave(stamp));
    ASSERT_TRUE(bench_->waitForForces(static_cast<std::size_t>(i) + 1));
    EXPECT_EQ(bench_->forces.back().force, expected_->push(stamp, wave(stamp)).force.total);
  }
  second.send(kStart + 98 * kMillisecond, 0.5);
  second.send(kStart + 99 * kMillisecond, 0.5);
  expectCounts({{"accepted", 100}, {"dropped", 2}, {"dropped, repeated stamp", 1}, {"dropped, stepped back", 1}});
}

// Relays displacements from another topic, and so is a second publisher for the component `two_publishers`.
int relay(int argc, char** argv) {
  ros::init(argc, argv, "relay");
  ros::NodeHandle handle;
  const ros::Publisher publisher = handle.advertise<Displacement>("two_publishers/displacement", 1000);
  const boost::function<void(const Displacement::ConstPtr&)> pass = [&](const Displacement::ConstPtr& message) {
    publisher.publish(*message);
  };
  while (publisher.getNumSubscribers() == 0 && ros::ok()) {
    ros::WallDuration(0.01).sleep();
  }
  const ros::Subscriber subscriber = handle.subscribe<Displacement>("relay/displacement", 1000, pass);
  ros::spin();
  return 0;
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "--relay") {
    return rubber_suspension::relay(argc, argv);
  }
  return rubber_suspension::runAsNode(argc, argv, "faults");
}
