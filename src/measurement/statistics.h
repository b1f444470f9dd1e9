// Small robust statistics that the measurement layer shares.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "rubber_suspension/measurement/faults.h"

namespace rubber_suspension::measurement {

constexpr double kMadToDeviation = 1.4826;  // of a normal variable

inline double medianOf(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

inline double rangeOf(const Eigen::VectorXd& values) { return values.maxCoeff() - values.minCoeff(); }

inline double rmsOf(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(values.size(), 1)));
}

/// Over the samples that count.
inline double meanSquare(const Eigen::VectorXd& signal, const Mask& mask) {
  return (signal.array() * mask.cast<double>()).square().sum() /
         std::max<double>(1.0, static_cast<double>(mask.count()));
}

inline double deviationOf(const Eigen::VectorXd& values) {
  return std::sqrt((values.array() - values.mean()).square().mean());
}

/// The smallest difference between neighbours that is not 0: the step of a coarse sensor, tiny for a fine one.
inline double smallestStep(const Eigen::VectorXd& values) {
  double smallest = HUGE_VAL;
  for (Eigen::Index i = 1; i < values.size(); ++i) {
    const double step = std::abs(values[i] - values[i - 1]);
    smallest = step > 0.0 ? std::min(smallest, step) : smallest;
  }
  return std::isfinite(smallest) ? smallest : 0.0;
}

}  // namespace rubber_suspension::measurement
