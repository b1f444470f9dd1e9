// Topics, services and parameters of the node `simulate` in one table. The reference page is generated from this table,
// and a rostest compares a running node with it.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// A topic or service of the node. In its name COMPONENT stands for the name of each component, DIRECTION for each
/// direction that is not free (x to rz), and ~ for the name of the node.
struct InterfaceEntry {
  /// Kind of entry: a topic that the node subscribes to, a topic that it publishes, or a service.
  enum class Kind { subscribed, published, service };

  std::string name;
  std::string type;
  Kind kind;
  std::string documentation;
  int directions = 0;  ///< 1 or 6 if the entry exists only for components with this number of directions; 0 otherwise
};

const std::vector<InterfaceEntry>& nodeInterface();

/// Returns Markdown: topics and services of the table, the private parameters, and the definition of every message.
std::string topicReference();

}  // namespace rubber_suspension::ros_interface
