// Memory that a diagnosis takes, so that logs beyond the machine's are refused before the search and not ended by it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::diagnosis::prepare {

/// Most that a diagnosis takes whose search takes so many samples, about, besides logs that are in memory [bytes].
std::uint64_t memoryNeeded(std::size_t samples, int threads);

/// Throws log::LogError where such a diagnosis, of logs of so many samples, takes more than what is available [bytes].
void requireMemory(std::size_t samples, std::size_t recorded, int threads, std::uint64_t available);

}  // namespace rubber_suspension::diagnosis::prepare
