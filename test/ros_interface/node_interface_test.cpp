// The page of topics in docs/ is the one that the code prints. That the table is what a running node offers is held by
// the rostest interface.
#include "rubber_suspension/ros_interface/node_interface.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace rubber_suspension {
namespace {

TEST(TopicReference, IsThePageInDocs) {
  std::ostringstream page;
  page << std::ifstream(TEST_DIR "/../docs/topics.md").rdbuf();
  EXPECT_EQ(page.str(), topicReference())
      << "after a change of a topic, message or parameter: rosrun rubber_suspension reference topics > docs/topics.md";
}

}  // namespace
}  // namespace rubber_suspension
