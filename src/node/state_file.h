// The file in which the node keeps the states of its components, so that it can go on where it stopped.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "node/component_channel.h"

namespace rubber_suspension::node {

/// A state file that cannot be read or written. what() is one line: file and reason.
class StateFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Write all states, every number to its last bit. The file is whole or as it was before, even if the power fails.
/// Throws StateFileError.
void writeStateFile(const std::string& path, const std::vector<SavedState>& states);

/// Read what writeStateFile wrote. Throws StateFileError.
std::vector<SavedState> readStateFile(const std::string& path);

}  // namespace rubber_suspension::node
