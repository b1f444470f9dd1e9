// The tables of the command `benchmark_latency` as figures.
#pragma once

#include <vector>

#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/ros_interface/latency_benchmark.h"
#include "rubber_suspension/ros_interface/soak.h"

namespace rubber_suspension {

/// Round trips, the ratios of the node to the echo node and of the echo node to itself, and the highest rates.
Figure latencyFigure(const std::vector<LatencyRow>& rows);

/// Resident memory over the samples served.
Figure soakFigure(const SoakResult& result);

}  // namespace rubber_suspension
