// Topics, services and parameters of the node `simulate` in one table, from which the reference page is generated and
// with which a rostest compares a running node.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// A topic or service of the node. In its name COMPONENT stands for the name of each component, DIRECTION for each
/// direction that is not free (x to rz), and ~ for the name of the node.
struct InterfaceEntry {
  /// Topic that the node subscribes to or publishes, or service.
  enum class Kind { subscribed, published, service };

  std::string name;
  std::string type;
  Kind kind;
  std::string documentation;
  int directions = 0;  ///< exists only for components with 1 or 6 directions; 0: for all
};

const std::vector<InterfaceEntry>& nodeInterface();

/// Returns Markdown: topics and services of the table, the private parameters, and the definition of every message.
std::string topicReference();

}  // namespace rubber_suspension::ros_interface
