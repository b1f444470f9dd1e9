// The file in which the node keeps the states of its components, so that it can continue where it stopped. Independent
// of ROS.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "node/component_channel.h"
#include "node/regular_file.h"

namespace rubber_suspension::node {

constexpr std::size_t kLargestStateFile = 32 * 1024 * 1024;  ///< bytes
constexpr int kDeepestStateFile = 8;                         ///< brackets within each other; a state needs 6

/// All states as text, every number to its last bit.
std::string stateText(const std::vector<SavedState>& states);

/// Parses the states of such a text. Throws FileError, also for a repeated component and for a stamp that no message
/// can have; `source` names the text in what().
std::vector<SavedState> parseStates(const std::string& text, const std::string& source);

/// Writes all states as replaceRegularFile() does. Throws FileError.
void writeStateFile(const std::string& path, const std::vector<SavedState>& states);

/// Reads a file of writeStateFile(). Throws FileError.
std::vector<SavedState> readStateFile(const std::string& path);

}  // namespace rubber_suspension::node
