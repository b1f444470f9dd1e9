// The tables of the command `benchmark_latency` as figures.
#pragma once

#include <vector>

#include "benchmark/latency/latency_benchmark.h"
#include "benchmark/latency/soak.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::benchmark {

/// Round trips, the ratios of the node to the echo node and of the echo node to itself, and the highest rates.
io::Figure latencyFigure(const std::vector<LatencyRow>& rows);

/// Resident memory over the samples served.
io::Figure soakFigure(const SoakResult& result);

}  // namespace rubber_suspension::benchmark
