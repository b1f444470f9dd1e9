// Noise of a recorded signal.
#include <algorithm>
#include <cmath>

#include "rubber_suspension/estimation/identification.h"

namespace rubber_suspension {
namespace {

constexpr int kHighestOrder = 10;
constexpr double kNormalMedian = 0.6745;  // median of |x| of a standard normal variable

double medianMagnitude(std::vector<double> values) {
  for (double& value : values) {
    value = std::abs(value);
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double noiseDeviation(const std::vector<double>& signal) {
  std::vector<double> differences = signal;
  double gain = 1.0;  // variance of the differences of white noise: the binomial coefficient (2 k over k)
  double smallest = HUGE_VAL;
  for (int order = 1; order <= kHighestOrder && differences.size() > 1; ++order) {
    for (std::size_t i = 0; i + 1 < differences.size(); ++i) {
      differences[i] = differences[i + 1] - differences[i];
    }
    differences.pop_back();
    gain *= (4.0 * order - 2.0) / order;
    smallest = std::min(smallest, medianMagnitude(differences) / (kNormalMedian * std::sqrt(gain)));
  }
  return std::isfinite(smallest) ? smallest : 0.0;
}

}  // namespace rubber_suspension
