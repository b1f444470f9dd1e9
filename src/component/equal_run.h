// Runs of equal values.
#pragma once

#include <algorithm>
#include <cstddef>

namespace rubber_suspension::component {

/// Returns how many of `count` values, at least 1, equal the first value without interruption.
inline std::size_t equalRun(const double* value, std::size_t count) {
  const double* const next = std::find_if(value, value + count, [&](double other) { return other != *value; });
  return static_cast<std::size_t>(next - value);
}

}  // namespace rubber_suspension::component
