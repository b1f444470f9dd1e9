// Memory needed by a diagnosis, so that logs too large for the machine are refused before the search.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::diagnosis::prepare {

/// Samples of a search, and the stretches of logs that they form.
struct Searched {
  std::size_t samples = 0;
  std::size_t stretches = 0;
};

/// Returns an upper bound of the memory that a diagnosis needs besides logs that are in memory [bytes].
std::uint64_t memoryNeeded(const Searched& searched, int threads);

/// Throws log::LogError if such a diagnosis, of logs of `recorded` samples, needs more than what is available [bytes].
void requireMemory(const Searched& searched, std::size_t recorded, int threads, std::uint64_t available);

}  // namespace rubber_suspension::diagnosis::prepare
