// The table of the benchmark as a figure.
#pragma once

#include <vector>

#include "measurement.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension {

/// The ratio of library to yardstick with its quartiles, one row per result.
Figure ratioFigure(const std::vector<Result>& results);

}  // namespace rubber_suspension
