// Runs of equal values.
#pragma once

#include <algorithm>
#include <cstddef>

namespace rubber_suspension::component {

/// How many values from the first on are equal to it; of `count` values, one at least.
inline std::size_t equalRun(const double* value, std::size_t count) {
  const double* const next = std::find_if(value, value + count, [&](double other) { return other != *value; });
  return static_cast<std::size_t>(next - value);
}

}  // namespace rubber_suspension::component
