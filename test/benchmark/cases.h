// The cases of the benchmark, in the order of its table.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "benchmark/measurement.h"

namespace rubber_suspension::benchmark {

struct BenchmarkSize {
  std::size_t samples = 100000;  ///< samples of the simulated logs, at 1 kHz
  int components = 1000;         ///< components that step at each tick
};

// Each returns the cases of a part of the table. The file of the function describes what the part measures.
std::vector<Case> forceCases(const BenchmarkSize& size);
std::vector<Case> sixDirectionCases(const BenchmarkSize& size);
std::vector<Case> bundleCases(const BenchmarkSize& size);

}  // namespace rubber_suspension::benchmark
