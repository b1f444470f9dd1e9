// Small robust statistics that the measurement layer shares.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "numerics/median.h"
#include "rubber_suspension/measurement/faults.h"

namespace rubber_suspension::measurement {

constexpr double kMadToDeviation = 1.4826;  // of a normal variable

using numerics::medianOf;

inline Eigen::VectorXd asVector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
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
