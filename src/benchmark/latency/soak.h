// Millions of samples through the node, as fast as it answers: every one has its force, and the memory does not grow.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::benchmark {

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

/// Resident memory over the samples served.
io::Figure soakFigure(const SoakResult& result);

/// Memory of a process that is resident [bytes]; 0 where there is no such process.
long residentMemory(int process);

}  // namespace rubber_suspension::benchmark
