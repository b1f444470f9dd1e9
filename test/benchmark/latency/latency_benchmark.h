// Compares the latency of the node with that of an empty echo node, in alternating runs on this machine.
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
  double rate = 1000.0;         ///< of each component, where that is not more than total_rate in all [Hz]
  double total_rate = 10000.0;  ///< samples of all components together, at most [Hz]
  double duration = 1.0;        ///< of each run [s]
  int pairs = 31;               ///< runs of echo node, node, and echo node again, per row
  double flood_duration = 2.0;  ///< of each run for the highest rate [s]
  bool diagnose = false;        ///< compare a node that diagnoses with one that does not, in the echo node's place
};

/// A quantile of the round trips over the runs.
struct LatencyQuantile {
  double echo = 0.0;  ///< of the echo node, median over the runs [s]
  io::Spread node;    ///< node to echo node
  io::Spread again;   ///< echo node to itself: what the machine does to such a ratio
};

/// One row of the table.
struct LatencyRow {
  int components = 0;
  bool bundled = false;
  bool diagnose = false;  ///< the node diagnoses, and the echo node is a node that does not
  double rate = 0.0;      ///< of each component [Hz]
  LatencyQuantile median;
  LatencyQuantile late;       ///< the 99th percentile
  std::size_t lost = 0;       ///< samples without answer, both nodes
  double echo_highest = 0.0;  ///< highest rate without loss, all components together [samples/s]
  double node_highest = 0.0;
};

/// Measure. Needs a master and starts nothing but the two nodes, which are this program's neighbours `simulate` and
/// `benchmark_latency --echo`. `progress` is told what is being measured. Throws std::runtime_error.
std::vector<LatencyRow> benchmarkLatency(const BenchmarkOptions& options,
                                         const std::function<void(const std::string&)>& progress);

/// The rows as a Markdown table.
void printMarkdown(const std::vector<LatencyRow>& rows, std::ostream& out);

// Millions of samples through the node, as fast as it answers: every one has its force, and the memory does not grow.

struct SoakResult {
  int components = 0;
  std::uint64_t sent = 0;
  std::uint64_t answered = 0;  ///< samples with exactly one force
  std::uint64_t surplus = 0;   ///< forces that belong to no sample, or to one that had its force
  double elapsed = 0.0;        ///< [s]
  std::vector<long> memory;    ///< resident memory of the node after each hundredth of the samples [bytes]

  bool exact() const { return answered == sent && surplus == 0; }
};

/// Soak the node that lies beside the running program, with so many samples of all components together. Needs a master.
/// `progress` is told of every tenth part. Throws std::runtime_error.
SoakResult soak(std::uint64_t samples, int components, const std::function<void(const std::string&)>& progress);

/// The result as a Markdown table.
void printMarkdown(const SoakResult& result, std::ostream& out);

/// Memory of a process that is resident [bytes]; 0 where there is no such process.
long residentMemory(int process);

}  // namespace rubber_suspension::benchmark
