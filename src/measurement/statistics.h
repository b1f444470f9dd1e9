// Small robust statistics that the measurement layer shares.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "numerics/median.h"
#include "rubber_suspension/measurement/faults.h"

namespace rubber_suspension::measurement {

constexpr double kMadToDeviation = 1.4826;  // standard deviation over median magnitude, of a normal variable

using numerics::medianOf;

inline Eigen::VectorXd asVector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

inline double rangeOf(const Eigen::VectorXd& values) { return values.maxCoeff() - values.minCoeff(); }

inline double rmsOf(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(values.size(), 1)));
}

/// Returns the mean square over the samples that count.
inline double meanSquare(const Eigen::VectorXd& signal, const Mask& mask) {
  return (signal.array() * mask.cast<double>()).square().sum() /
         std::max<double>(1.0, static_cast<double>(mask.count()));
}

/// Replaces the samples that do not count by linear interpolation between those that do, or by 0 if none does.
inline void bridge(Eigen::Ref<Eigen::VectorXd> values, const Mask& mask) {
  const Eigen::Index count = mask.size();
  Eigen::Index last = -1;  // index of the last sample that counts
  for (Eigen::Index i = 0; i <= count; ++i) {
    if (i < count && !mask[i]) {
      continue;
    }
    for (Eigen::Index j = last + 1; j < i; ++j) {
      const double before = last >= 0 ? values[last] : (i < count ? values[i] : 0.0);
      const double after = i < count ? values[i] : before;
      values[j] = before + (after - before) * static_cast<double>(j - last) / static_cast<double>(i - last);
    }
    last = i;
  }
}

/// Returns the smallest nonzero difference between neighbours: the step of a coarse sensor, tiny for a fine one.
inline double smallestStep(const Eigen::VectorXd& values) {
  double smallest = HUGE_VAL;
  for (Eigen::Index i = 1; i < values.size(); ++i) {
    const double step = std::abs(values[i] - values[i - 1]);
    smallest = step > 0.0 ? std::min(smallest, step) : smallest;
  }
  return std::isfinite(smallest) ? smallest : 0.0;
}

}  // namespace rubber_suspension::measurement
