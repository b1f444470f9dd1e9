// Cases of the benchmark: the parts of the table, and single pieces of work.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "benchmark/measurement.h"

namespace rubber_suspension::benchmark {

struct BenchmarkSize {
  std::size_t samples = 100000;  ///< of the simulated logs, at 1 kHz
  int components = 1000;         ///< at each tick
};

// The parts of the table; their files describe what they measure.
std::vector<Case> forceCases(const BenchmarkSize& size);
std::vector<Case> sixDirectionCases(const BenchmarkSize& size);
std::vector<Case> bundleCases(const BenchmarkSize& size);

}  // namespace rubber_suspension::benchmark
