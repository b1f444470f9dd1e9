// Memory that a diagnosis takes.
#include "diagnosis/memory.h"

#include <fmt/format.h>

#include <string>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::diagnosis {
namespace {

// Every basis term of every candidate keeps its force over all samples, twice where the logs without what the rig did
// are searched again, and each thread has columns of its own. Measured as the resident memory at its peak: with two
// threads 3090 bytes a sample for 300,000 samples, 3158 for 600,000, 3186 for 1,200,000; for 120,000 with one, two and
// eight threads 2729, 2946 and 4462.
constexpr std::uint64_t kBytesPerSample = 2700;
constexpr std::uint64_t kBytesPerSampleAndThread = 250;
constexpr std::uint64_t kBytesOfProgram = 64 * 1024 * 1024;

std::string readable(std::uint64_t bytes) {
  const double mebibytes = static_cast<double>(bytes) / (1024.0 * 1024.0);
  return mebibytes < 1000.0 ? fmt::format("{:.0f} MiB", mebibytes) : fmt::format("{:.1f} GiB", mebibytes / 1024.0);
}

std::uint64_t bytesPerSample(int threads) {
  return kBytesPerSample + kBytesPerSampleAndThread * static_cast<std::uint64_t>(threads);
}

}  // namespace

std::uint64_t memoryNeeded(std::size_t samples, int threads) {
  return kBytesOfProgram + bytesPerSample(threads) * samples;
}

void requireMemory(std::size_t samples, int threads, std::uint64_t available) {
  const std::uint64_t needed = memoryNeeded(samples, threads);
  if (needed > available) {
    const std::size_t most = available > kBytesOfProgram ? (available - kBytesOfProgram) / bytesPerSample(threads) : 0;
    throw log::LogError(
        fmt::format("the logs have {} samples, and a diagnosis of them takes about {}, of which {} are available; "
                    "accepted: {} samples in all, by fewer or shorter logs or a lower sampling rate",
                    samples, readable(needed), readable(available), most));
  }
}

}  // namespace rubber_suspension::diagnosis
