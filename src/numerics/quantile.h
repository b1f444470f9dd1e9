// Quantiles.
#pragma once

#include <algorithm>
#include <vector>

namespace rubber_suspension::numerics {

/// Returns the value below which a share of the sorted values (at least one) lies, by linear interpolation.
inline double quantileOf(const std::vector<double>& sorted, double share) {
  const double rank = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace rubber_suspension::numerics
