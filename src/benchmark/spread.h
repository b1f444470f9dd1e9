// The median and the quartiles of repeated measurements.
#pragma once

#include <algorithm>
#include <vector>

#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::benchmark {

/// Median and quartiles, linear between the ranks. The list must not be empty.
inline io::Spread spreadOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    const double rank = part * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (rank - static_cast<double>(below)) * (values[above] - values[below]);
  };
  return {at(0.5), at(0.25), at(0.75)};
}

}  // namespace rubber_suspension::benchmark
