// The page of topics in docs/ equals the output of the code. The rostest `interface` compares the table with a node.
#include "ros_interface/node_interface.h"

#include "support/files.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(TopicReference, IsThePageInDocs) {
  EXPECT_EQ(pageInDocs("topics"), ros_interface::topicReference())
      << "after a change of a topic, message or parameter: rosrun rubber_suspension reference topics > docs/topics.md";
}

}  // namespace
}  // namespace rubber_suspension
