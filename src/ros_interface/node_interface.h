// Topics, services and parameters of the node `simulate`, in one table; the reference page is written from it, and a
// rostest holds a running node to it.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// A topic or service of the node. In its name COMPONENT stands for the name of each component, DIRECTION
/// for each that is not free, x to rz, ~ for the node's.
struct InterfaceEntry {
  /// Who sends.
  enum class Kind { subscribed, published, service };

  std::string name;
  std::string type;
  Kind kind;
  std::string documentation;
  int directions = 0;  ///< of a component of one direction or of six alone; 0: of every one
};

const std::vector<InterfaceEntry>& nodeInterface();

/// Markdown: topics and services of the table, the private parameters, and the definition of every message.
std::string topicReference();

}  // namespace rubber_suspension::ros_interface
