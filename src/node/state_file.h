// The file in which the node stores the states of its components, to continue from them later. Independent of ROS.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "node/component_channel.h"
#include "node/regular_file.h"

namespace rubber_suspension::node {

constexpr std::size_t kLargestStateFile = 32 * 1024 * 1024;  ///< bytes
constexpr int kDeepestStateFile = 8;                         ///< largest number of nested brackets; a state needs 6

/// Returns all states as text, which preserves every number to the last bit.
std::string stateText(const std::vector<SavedState>& states);

/// Returns the states in a text of stateText(). Throws FileError, which begins with `source`, also for a repeated
/// component and for a stamp that no message can have.
std::vector<SavedState> parseStates(const std::string& text, const std::string& source);

/// Writes all states as replaceRegularFile() does. Throws FileError.
void writeStateFile(const std::string& path, const std::vector<SavedState>& states);

/// Reads a file that writeStateFile() has written. Throws FileError.
std::vector<SavedState> readStateFile(const std::string& path);

}  // namespace rubber_suspension::node
