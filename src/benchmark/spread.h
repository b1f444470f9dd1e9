// The median and the quartiles of repeated measurements.
#pragma once

#include <algorithm>
#include <vector>

#include "numerics/quantile.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::benchmark {

/// Median and quartiles, linear between the ranks. The list must not be empty.
inline io::Spread spreadOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {numerics::quantileOf(values, 0.5), numerics::quantileOf(values, 0.25), numerics::quantileOf(values, 0.75)};
}

}  // namespace rubber_suspension::benchmark
