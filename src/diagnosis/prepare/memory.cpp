// Estimates the memory that a diagnosis needs.
#include "diagnosis/prepare/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::diagnosis::prepare {
namespace {

// Each basis term of each candidate stores its force on all samples, and each thread stores forces of its own. Measured
// with test/usage/memory_limit_trial.py as the peak resident memory minus that of the program: with two threads, 3530
// bytes per sample for a log of 120,000 samples and 3570 bytes for one of 100,000 samples. A thread needs more if many
// effects have to be simulated.
constexpr std::uint64_t kBytesPerSample = 3150;
constexpr std::uint64_t kBytesPerSampleAndThread = 250;
constexpr std::uint64_t kBytesOfProgram = 64 * 1024 * 1024;
constexpr std::uint64_t kBytesOfThread = 16 * 1024 * 1024;  // stack of the thread and arena of its allocator

std::string readable(std::uint64_t bytes) {
  const double mebibytes = static_cast<double>(bytes) / (1024.0 * 1024.0);
  return mebibytes < 1000.0 ? fmt::format("{:.0f} MiB", mebibytes) : fmt::format("{:.1f} GiB", mebibytes / 1024.0);
}

// Each block of the logs (fit::LogBlocks) stores the products of at most some 200 columns of the least-squares system.
constexpr std::uint64_t kBytesPerBlock = 400 * 1024;

std::uint64_t blocksOf(std::uint64_t stretches) {
  return std::min(24 * stretches, std::max(std::uint64_t{480}, 2 * stretches));
}

std::uint64_t bytesPerSample(int threads) {
  return kBytesPerSample + kBytesPerSampleAndThread * static_cast<std::uint64_t>(threads);
}

}  // namespace

std::uint64_t memoryNeeded(const Searched& searched, int threads) {
  return kBytesOfProgram + kBytesOfThread * static_cast<std::uint64_t>(threads) +
         kBytesPerBlock * blocksOf(searched.stretches) + bytesPerSample(threads) * searched.samples;
}

void requireMemory(const Searched& searched, std::size_t recorded, int threads, std::uint64_t available) {
  const std::uint64_t needed = memoryNeeded(searched, threads);
  if (needed > available) {
    const std::uint64_t fixed = memoryNeeded({0, searched.stretches}, threads);
    const std::uint64_t most = available > fixed ? (available - fixed) / bytesPerSample(threads) : 0;
    throw log::LogError(
        fmt::format("a search over {} of {} samples needs about {} of memory, but only {} are available; accepted: at "
                    "most {} samples (--most-samples), or fewer or shorter logs",
                    searched.samples, recorded, readable(needed), readable(available), most));
  }
}

}  // namespace rubber_suspension::diagnosis::prepare
