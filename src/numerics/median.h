// The median.
#pragma once

#include <algorithm>
#include <vector>

namespace rubber_suspension::numerics {

/// Returns the median, which is the upper middle value for an even count and 0 without values. Reorders the values.
template <class Number>
Number medianIn(std::vector<Number>& values) {
  if (values.empty()) {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the median as medianIn(), without reordering the argument.
template <class Number>
Number medianOf(std::vector<Number> values) {
  return medianIn(values);
}

}  // namespace rubber_suspension::numerics
