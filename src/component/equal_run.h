// Runs of equal values.
#pragma once

#include <algorithm>
#include <cstddef>

namespace rubber_suspension::component {

/// Returns the number of leading values that equal the first value. `count` has to be at least 1.
inline std::size_t equalRun(const double* value, std::size_t count) {
  const double* const next = std::find_if(value, value + count, [&](double other) { return other != *value; });
  return static_cast<std::size_t>(next - value);
}

}  // namespace rubber_suspension::component
