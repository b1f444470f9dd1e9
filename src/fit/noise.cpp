// Noise of a recorded signal.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "numerics/median.h"
#include "rubber_suspension/fit/identification.h"

namespace rubber_suspension::fit {

double noiseStandardDeviation(const std::vector<double>& signal, double negligible) {
  constexpr int kHighestOrder = 10;
  constexpr double kNormalMedian = 0.6745;  // median of |x| of a standard normal variable
  std::vector<double> values = signal;
  double gain = 1.0;  // variance of the differences of white noise: the binomial coefficient (2 k over k)
  double smallest = HUGE_VAL;
  for (int order = 1; order <= kHighestOrder && values.size() > 1 && smallest > negligible; ++order) {
    std::adjacent_difference(values.begin(), values.end(), values.begin());
    values.erase(values.begin());
    gain *= (4.0 * order - 2.0) / order;
    std::vector<double> magnitude = values;
    std::transform(values.begin(), values.end(), magnitude.begin(), [](double value) { return std::abs(value); });
    smallest = std::min(smallest, numerics::medianOf(std::move(magnitude)) / (kNormalMedian * std::sqrt(gain)));
  }
  return smallest > negligible && std::isfinite(smallest) ? smallest : 0.0;
}

}  // namespace rubber_suspension::fit
