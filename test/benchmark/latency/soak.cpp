// The soak test with millions of samples.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <ostream>

#include "benchmark/latency/benchmark_node.h"
#include "benchmark/latency/latency_benchmark.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr int kPieces = 100;
constexpr std::size_t kSamplesUnderWay = 100;  // unanswered samples of each component

double mebibytes(long bytes) { return static_cast<double>(bytes) / (1024.0 * 1024.0); }

}  // namespace

long residentMemory(int process) {
  std::ifstream file(fmt::format("/proc/{}/statm", process));
  long all = 0;
  long resident = 0;
  file >> all >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

SoakResult soak(std::uint64_t samples, int components, const std::function<void(const std::string&)>& progress) {
  SoakResult result;
  result.components = components;
  BenchmarkNode node(NodeKind::plain, components);
  const auto per_piece = std::max<std::uint64_t>(1, samples / (kPieces * static_cast<std::uint64_t>(components)));
  for (int piece = 0; piece < kPieces; ++piece) {
    const RoundTrips trips = node.meter().flood(std::numeric_limits<int>::max(), kSamplesUnderWay, per_piece);
    result.sent += trips.sent;
    result.answered += trips.durations.size();
    result.surplus += trips.surplus;
    result.elapsed += trips.elapsed;
    result.memory.push_back(residentMemory(node.process()));
    if (piece % 10 == 9) {
      progress(fmt::format("{} samples, {} forces, {:.1f} MiB", result.sent, result.answered,
                           mebibytes(result.memory.back())));
    }
  }
  return result;
}

void printMarkdown(const SoakResult& result, std::ostream& out) {
  out << "| components | samples | with one force | surplus forces | samples/s | resident after 1 %, at the end, at "
         "most [MiB] |\n"
         "|---|---|---|---|---|---|\n"
      << fmt::format("| {} | {} | {} | {} | {:.0f} | {:.2f}, {:.2f}, {:.2f} |\n", result.components, result.sent,
                     result.answered, result.surplus, static_cast<double>(result.answered) / result.elapsed,
                     mebibytes(result.memory.front()), mebibytes(result.memory.back()),
                     mebibytes(*std::max_element(result.memory.begin(), result.memory.end())));
}

}  // namespace rubber_suspension::benchmark
