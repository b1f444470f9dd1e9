// The message pool reuses a message only after nobody uses it any more.
#include "ros_interface/message_pool.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(MessagePool, UsesMessagesAgain) {
  ros_interface::MessagePool<std::string> pool;
  std::set<std::string*> seen;
  for (int i = 0; i < 100; ++i) {
    const auto held = pool.take();
    seen.insert({held.get(), pool.take().get()});
  }
  EXPECT_EQ(seen.size(), 2U);
  EXPECT_EQ(pool.size(), 2U);
}

TEST(MessagePool, NeverHandsOutWhatSomebodyHolds) {
  ros_interface::MessagePool<std::string> pool;
  std::vector<ros_interface::MessagePool<std::string>::Pointer> held;
  std::set<std::string*> seen;
  for (int i = 0; i < 3000; ++i) {
    held.push_back(pool.take());
    EXPECT_TRUE(seen.insert(held.back().get()).second);
  }
  EXPECT_LE(pool.size(), 1024U);
}

}  // namespace
}  // namespace rubber_suspension
