// Memory that a diagnosis takes, so that logs beyond the machine's are refused before the search and not ended by it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::diagnosis::prepare {

/// Samples of a search, in so many stretches of logs.
struct Searched {
  std::size_t samples = 0;
  std::size_t stretches = 0;
};

/// Most that a diagnosis takes besides logs that are in memory [bytes].
std::uint64_t memoryNeeded(const Searched& searched, int threads);

/// Throws log::LogError where such a diagnosis, of logs of so many samples, takes more than what is available [bytes].
void requireMemory(const Searched& searched, std::size_t recorded, int threads, std::uint64_t available);

}  // namespace rubber_suspension::diagnosis::prepare
