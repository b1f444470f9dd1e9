// The master dies and returns. The node answers samples meanwhile, and clients find the node again afterwards.
#include <std_srvs/Trigger.h>

#include <cstdlib>
#include <memory>

#include "bench.h"
#include "ros_interface/child_process.h"

namespace rubber_suspension {
namespace {

class MasterRestart : public testing::Test {
 protected:
  // Starts a master for this test alone, because the master of rostest must stay alive.
  static std::unique_ptr<ros_interface::ChildProcess> startMaster(int port) {
    auto master = std::make_unique<ros_interface::ChildProcess>(
        std::vector<std::string>{"rosmaster", "--core", "-p", std::to_string(port)});
    EXPECT_TRUE(spinUntil([] { return ros::master::check(); }));
    return master;
  }
};

int port = 0;
std::string config_file;

TEST_F(MasterRestart, SamplesAreServedAndTheNodeIsFoundAgain) {
  auto master = startMaster(port);
  const ros_interface::ChildProcess node({ros_interface::siblingProgram("simulate"), "_config_file:=" + config_file});
  Bench left("left_secondary");
  ASSERT_TRUE(left.connect());
  for (int i = 0; i < 100; ++i) {
    left.ask(kStart + i * kMillisecond, 1e-5 * i);
  }
  master.reset();
  EXPECT_FALSE(ros::master::check());
  for (int i = 100; i < 300; ++i) {
    left.ask(kStart + i * kMillisecond, 1e-5 * i);
  }
  master = startMaster(port);
  for (int i = 300; i < 400; ++i) {
    left.ask(kStart + i * kMillisecond, 1e-5 * i);
  }
  EXPECT_EQ(left.forces.size(), 400U);

  // Within seconds the node registers again, so that a new client finds it.
  Bench right("right_secondary");
  ASSERT_TRUE(right.connect());
  EXPECT_NEAR(right.ask(kStart, 0.002).displacement, 0.002, 0.0);
  ASSERT_TRUE(ros::service::waitForService("/simulate/reset", ros::Duration(kPatience)));
  std_srvs::Trigger reset;
  EXPECT_TRUE(ros_interface::callService("/simulate/reset", reset));
  EXPECT_TRUE(reset.response.success);
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  rubber_suspension::config_file = std::string(TEST_DIR) + "/rostest/config/two_components.yaml";
  rubber_suspension::port = rubber_suspension::ros_interface::freePort();
  setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + std::to_string(rubber_suspension::port)).c_str(), 1);
  ros::init(argc, argv, "master_restart");
  return RUN_ALL_TESTS();
}
