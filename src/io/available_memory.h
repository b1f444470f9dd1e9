// Memory that is available to this process. The computer, control groups and the limit of the process restrict it.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace rubber_suspension::io {

constexpr std::uint64_t kUnlimitedMemory = std::numeric_limits<std::uint64_t>::max();

/// Returns the smallest of three sizes [bytes], or kUnlimitedMemory if none of them is known: the memory of the
/// computer that is available without swapping (MemAvailable), the free memory of the control groups of the process
/// (version 1 or 2; inactive file cache counts as free), and the free address space (RLIMIT_AS). `root` is a prefix of
/// /proc and /sys. Throws nothing.
std::uint64_t availableMemory(const std::string& root = "");

}  // namespace rubber_suspension::io
