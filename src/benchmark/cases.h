// What is measured: one function per part of the table.
#pragma once

#include <cstddef>
#include <vector>

#include "benchmark/measurement.h"

namespace rubber_suspension::benchmark {

struct BenchmarkSize {
  std::size_t samples = 100000;  ///< of the logs that are simulated, at 1 kHz
  double log_duration = 20.0;    ///< of the logs that are diagnosed [s]
  int components = 1000;         ///< at one tick
};

/// One component sample by sample, with constant and varying steps, by Component and by SampleStream; growth with the
/// number of Maxwell elements; a log offline; many components at each tick; a general solver of differential equations
/// and a multibody program.
std::vector<Case> forceCases(const BenchmarkSize& size);

/// A component of six directions against six components of one.
std::vector<Case> sixDirectionCases(const BenchmarkSize& size);

/// Estimation from five inputs.
std::vector<Case> estimationCases(const BenchmarkSize& size);

/// Reading a log from text, in the form that this package writes and in another dialect.
std::vector<Case> logCases(const BenchmarkSize& size);

/// Bundles of the node under the lock that makes a saved state one instant, against bundles without it; a save.
std::vector<Case> bundleCases(const BenchmarkSize& size);

/// Fit and diagnosis of logs, in one thread and in two.
std::vector<Case> diagnosisCases(const BenchmarkSize& size);

}  // namespace rubber_suspension::benchmark
