// Estimates the memory that a diagnosis needs, so that logs too large for this computer are refused before the search.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::diagnosis::prepare {

/// Number of samples in a search, and number of contiguous stretches of logs that they form.
struct Searched {
  std::size_t samples = 0;
  std::size_t stretches = 0;
};

/// Returns an upper bound [bytes] of the memory that a diagnosis needs, not counting logs that are in memory already.
std::uint64_t memoryNeeded(const Searched& searched, int threads);

/// Throws log::LogError if the diagnosis needs more memory than the `available` bytes. `recorded` is the number of
/// samples in the logs, which the message states.
void requireMemory(const Searched& searched, std::size_t recorded, int threads, std::uint64_t available);

}  // namespace rubber_suspension::diagnosis::prepare
