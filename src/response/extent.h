// The extent of a periodic signal.
#pragma once

#include <algorithm>
#include <vector>

namespace rubber_suspension::response {

/// Largest value less the smallest; at least one value is needed.
inline double extent(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

}  // namespace rubber_suspension::response
