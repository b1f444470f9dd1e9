// The table of the benchmark as a figure.
#pragma once

#include <vector>

#include "benchmark/measurement.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::benchmark {

/// The ratio of library to baseline with its quartiles, one row per result.
io::Figure ratioFigure(const std::vector<Result>& results);

}  // namespace rubber_suspension::benchmark
