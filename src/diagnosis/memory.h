// Memory that a diagnosis takes, so that logs beyond the machine's are refused before the search and not ended by it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::diagnosis {

/// Most that a diagnosis of logs with so many samples in all takes, about [bytes].
std::uint64_t memoryNeeded(std::size_t samples, int threads);

/// Throws log::LogError where a diagnosis of so many samples takes more than what is available [bytes].
void requireMemory(std::size_t samples, int threads, std::uint64_t available);

}  // namespace rubber_suspension::diagnosis
