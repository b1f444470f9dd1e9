// A watchdog detects a callback that blocks a serving thread, and reports it with the name of the thread.
#include "ros_interface/serving_thread.h"

#include <ros/callback_queue_interface.h>

#include <boost/make_shared.hpp>
#include <chrono>
#include <future>

#include "ros_interface/node_diagnostics.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

// Blocks its thread until it is released.
class Hold : public ros::CallbackInterface {
 public:
  CallResult call() override {
    begun.set_value();
    go_on.get_future().wait();
    return Success;
  }

  std::promise<void> begun;
  std::promise<void> go_on;
};

template <class Condition>
bool becomes(Condition condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);  // only ends a failed test
  while (!condition() && std::chrono::steady_clock::now() < end) {
    std::this_thread::yield();
  }
  return condition();
}

TEST(ServingThread, ItsSilenceGrowsWhileACallbackHoldsItUp) {
  ros_interface::ServingThread thread;
  EXPECT_EQ(thread.start("serving 1", 0), "");
  const auto hold = boost::make_shared<Hold>();
  thread.queue().addCallback(hold);
  hold->begun.get_future().wait();
  EXPECT_TRUE(becomes([&] { return thread.silence() > 0.5; }));
  hold->go_on.set_value();
  EXPECT_TRUE(becomes([&] { return thread.silence() < 0.5; }));
  thread.stop();
}

TEST(ServingThread, IsStaleAfterTwoSecondsWithItsName) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  ros_interface::fillThreadStatus("serving 3", 0.1, status);
  EXPECT_EQ(status.level, diagnostic_msgs::DiagnosticStatus::OK);
  ros_interface::fillThreadStatus("serving 3", 2.1, status);
  EXPECT_EQ(status.level, diagnostic_msgs::DiagnosticStatus::STALE);
  EXPECT_THAT(status.message, testing::HasSubstr("serving 3"));
}

}  // namespace
}  // namespace rubber_suspension
