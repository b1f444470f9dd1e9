// The median.
#pragma once

#include <algorithm>
#include <vector>

namespace rubber_suspension::numerics {

/// Returns the upper of the two middle values for an even count, 0 for none. Changes the order of the values.
template <class Number>
Number medianIn(std::vector<Number>& values) {
  if (values.empty()) {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the median; the values keep their order.
template <class Number>
Number medianOf(std::vector<Number> values) {
  return medianIn(values);
}

}  // namespace rubber_suspension::numerics
