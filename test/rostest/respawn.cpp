// A node that ends during a run is started again, and serves from rest or from its saved state.
#include <signal.h>
#include <std_srvs/Trigger.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>

#include "bench.h"
#include "node_process.h"

namespace rubber_suspension {
namespace {

double wave(int i) { return 2e-3 * std::sin(0.025 * i); }

class Respawn : public testing::Test {
 protected:
  void open(const std::string& component) {
    bench_ = std::make_unique<Bench>(component);
    ASSERT_TRUE(bench_->connect());
  }

  void ask(int first, int end) {
    for (int i = first; i < end; ++i) {
      bench_->ask(kStart + i * kMillisecond, wave(i));
    }
  }

  // Ends the node while some samples have no answer, and waits until its successor serves the bench.
  void endAndWait(const std::string& node, const std::function<void(pid_t)>& end) {
    const pid_t before = processOf(node);
    ASSERT_GT(before, 0);
    for (int i = 0; i < 2000; ++i) {
      bench_->send(kStart + (kUnderWay + i) * kMillisecond, wave(kUnderWay + i));
    }
    end(before);
    ASSERT_TRUE(spinUntil([&] { return !bench_->isHeard(); }));
    ASSERT_TRUE(spinUntil([&] {
      const pid_t now = processOf(node);
      return now > 0 && now != before;
    }));
    ASSERT_TRUE(bench_->connect());
  }

  static void killIt(pid_t process) { ASSERT_EQ(kill(process, SIGKILL), 0); }

  static constexpr int kUnderWay = 10000;  // number of the first sample without an answer at the end
  std::unique_ptr<Bench> bench_;
};

TEST_F(Respawn, ServesAgainAfterItWasKilled) {
  open("left_secondary");
  ask(0, 100);
  EXPECT_EQ(bench_->forces.size(), 100U);
  endAndWait("/simulate", killIt);

  // A sample in transit when the node ends is answered at most once.
  std::set<ros::Time> stamps;
  for (const Force& force : bench_->forces) {
    EXPECT_TRUE(stamps.insert(force.header.stamp).second) << force.header.stamp;
    EXPECT_TRUE(std::isfinite(force.force));
  }
  const std::size_t before = bench_->forces.size();
  DiagnosticsWatch diagnostics;
  // The component is new and at rest, so 2 mm give the force of the static stiffness of 3 kN/mm.
  EXPECT_NEAR(bench_->ask(kStart + 20000 * kMillisecond, 0.002).force, 6000.0, 1e-6);
  ask(20001, 20050);
  EXPECT_EQ(bench_->forces.size(), before + 50);
  EXPECT_TRUE(diagnostics.waitForCount("left_secondary", "accepted", 50));
}

// The call `shutdown` of the slave API ends the node without an error. Any client may send this call.
TEST_F(Respawn, GoesOnBitByBitWhereTheStateWasSaved) {
  const std::string node = "/keeping/simulate";
  const auto shut_down = [&](pid_t /*process*/) {
    XmlRpc::XmlRpcValue arguments;
    arguments[1] = "a stranger's call";
    askNode(node, "shutdown", arguments);
  };
  open("keeping/left_secondary");
  ask(0, 100);
  ASSERT_TRUE(ros::service::waitForService(node + "/save_state", ros::Duration(kPatience)));
  std_srvs::Trigger save;
  ASSERT_TRUE(ros_interface::callService(node + "/save_state", save));
  ASSERT_TRUE(save.response.success) << save.response.message;
  ask(100, 200);
  const std::vector<Force> without_interruption(bench_->forces.begin() + 100, bench_->forces.begin() + 200);
  for (const std::function<void(pid_t)>& end : {std::function<void(pid_t)>(killIt), {shut_down}}) {
    endAndWait(node, end);
    bench_->forces.clear();
    ask(100, 200);
    ASSERT_EQ(bench_->forces.size(), 100U);
    for (std::size_t i = 0; i < 100; ++i) {
      EXPECT_EQ(bench_->forces[i].force, without_interruption[i].force) << "sample " << i;
    }
  }
  EXPECT_TRUE(std::filesystem::remove(ros::param::param<std::string>(node + "/state_file", "")));
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "respawn"); }
