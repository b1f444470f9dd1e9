// Compares the latency of the node with that of an echo node without components, in alternating runs on one computer.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::benchmark {

struct BenchmarkOptions {
  std::vector<int> components = {1, 10, 50};
  double rate = 1000.0;         ///< sampling rate of each component, limited by total_rate [Hz]
  double total_rate = 10000.0;  ///< largest rate of all components together [Hz]
  double duration = 1.0;        ///< duration of each run [s]
  int pairs = 31;               ///< runs of echo node, node, and echo node again, per row
  double flood_duration = 2.0;  ///< duration of each run at the highest rate [s]
  bool diagnose = false;        ///< compare a node with and without the diagnosis, instead of an echo node
};

/// A quantile of the round-trip times over the runs.
struct LatencyQuantile {
  double echo = 0.0;  ///< of the echo node, median over the runs [s]
  io::Spread node;    ///< ratio of the node to the echo node
  io::Spread again;   ///< ratio of the echo node to itself, which shows the scatter of the computer
};

/// One row of the table.
struct LatencyRow {
  int components = 0;
  bool bundled = false;
  bool diagnose = false;  ///< the node diagnoses, and the baseline is a node without the diagnosis
  double rate = 0.0;      ///< sampling rate of each component [Hz]
  LatencyQuantile median;
  LatencyQuantile late;       ///< 99th percentile
  std::size_t lost = 0;       ///< unanswered samples of both nodes
  double echo_highest = 0.0;  ///< highest rate without loss, all components together [samples/s]
  double node_highest = 0.0;
};

/// Measures the latencies. Requires a master, and starts two nodes: `simulate`, and `benchmark_latency --echo` in the
/// folder of this program. Reports each step to `progress`. Throws std::runtime_error.
std::vector<LatencyRow> benchmarkLatency(const BenchmarkOptions& options,
                                         const std::function<void(const std::string&)>& progress);

/// Prints the rows as a Markdown table.
void printMarkdown(const std::vector<LatencyRow>& rows, std::ostream& out);

// The soak test sends millions of samples as fast as the node answers. Each has its force, and the memory is constant.

struct SoakResult {
  int components = 0;
  std::uint64_t sent = 0;
  std::uint64_t answered = 0;  ///< samples with exactly one force
  std::uint64_t surplus = 0;   ///< forces without a sample, and further forces of a sample
  double elapsed = 0.0;        ///< [s]
  std::vector<long> memory;    ///< resident memory of the node after each hundredth of the samples [bytes]

  bool exact() const { return answered == sent && surplus == 0; }
};

/// Sends this total number of samples for all components to the node in the folder of this program. Requires a master.
/// Reports every tenth of the samples to `progress`. Throws std::runtime_error.
SoakResult soak(std::uint64_t samples, int components, const std::function<void(const std::string&)>& progress);

/// Prints the result as a Markdown table.
void printMarkdown(const SoakResult& result, std::ostream& out);

/// Returns the resident memory of a process [bytes], or 0 if there is no such process.
long residentMemory(int process);

}  // namespace rubber_suspension::benchmark
