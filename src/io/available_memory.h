// Memory that this process may still take: of the machine, of its control groups, of its own limit.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace rubber_suspension::io {

constexpr std::uint64_t kUnlimitedMemory = std::numeric_limits<std::uint64_t>::max();

/// The least of what is left [bytes]: of the machine's memory without swapping (MemAvailable), of each control group
/// that the process is in (version 1 or 2; files that the kernel holds only for speed are left out of what is taken),
/// and of the limit of its addresses (RLIMIT_AS). kUnlimitedMemory where the system tells nothing. `root` stands before
/// /proc and /sys. Throws nothing.
std::uint64_t availableMemory(const std::string& root = "");

}  // namespace rubber_suspension::io
