// Memory that is available to this process, by the machine, its control groups and its own limit.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace rubber_suspension::io {

constexpr std::uint64_t kUnlimitedMemory = std::numeric_limits<std::uint64_t>::max();

/// Returns the least [bytes] of the machine's memory that is available without swapping (MemAvailable), of what each
/// control group of the process has left (version 1 or 2; inactive file cache counts as free), and of the address space
/// left (RLIMIT_AS); kUnlimitedMemory if none is known. `root` is a prefix of /proc and /sys. Throws nothing.
std::uint64_t availableMemory(const std::string& root = "");

}  // namespace rubber_suspension::io
