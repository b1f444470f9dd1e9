// What is measured: the parts of the table, and single pieces of work.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "benchmark/measurement.h"

namespace rubber_suspension::benchmark {

struct BenchmarkSize {
  std::size_t samples = 100000;  ///< of the logs that are simulated, at 1 kHz
  int components = 1000;         ///< at one tick
};

// The parts of the table; their files say what they measure.
std::vector<Case> forceCases(const BenchmarkSize& size);
std::vector<Case> sixDirectionCases(const BenchmarkSize& size);
std::vector<Case> bundleCases(const BenchmarkSize& size);

/// Time `simulate` (the force of a log, median of some runs) or `fit` (of the only component of the file to the log,
/// from one start), in seconds of the thread, for scripts that time others by turns with it. Returns JSON: seconds, and
/// of a fit its cost, the sum of squared residuals [N^2]. Throws ComponentFileError, LogError and
/// std::invalid_argument.
std::string singleWork(const std::string& work, const std::string& component_file, const std::string& log);

}  // namespace rubber_suspension::benchmark
