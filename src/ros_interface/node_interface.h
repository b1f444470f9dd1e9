// What the node `simulate` can be asked over ROS, in one table; the reference page is written from it, and a rostest
// holds a running node to it.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// A topic or service of the node. In its name COMPONENT stands for the name of each component, ~ for the node's.
struct InterfaceEntry {
  /// Who sends.
  enum class Kind { subscribed, published, service };

  std::string name;
  std::string type;
  Kind kind;
  std::string documentation;
};

const std::vector<InterfaceEntry>& nodeInterface();

/// Markdown: the --help-all of each command. Throws as outputOf().
std::string commandReference(const std::vector<std::string>& commands);

/// Markdown: topics and services of the table, the private parameters, and the definition of every message.
std::string topicReference();

}  // namespace rubber_suspension::ros_interface
