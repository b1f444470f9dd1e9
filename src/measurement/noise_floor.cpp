// The noise floor of a log.
#include "rubber_suspension/measurement/noise_floor.h"

#include <algorithm>
#include <cmath>

#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::measurement {
namespace {

constexpr double kHarmonics = 3.0;    // of the motion's highest frequency: what a law of rubber answers with
constexpr double kHighestEdge = 0.3;  // cycles per sample: above it there have to be enough lines

Mask maskOf(const log::Record& record) {
  return record.counts.size() == 0 ? Mask::Constant(record.size(), true) : (record.counts.array() > 0.0).eval();
}

// Standard deviation of the rounding to the smallest difference of neighbouring values that is not 0.
double rounding(const Eigen::VectorXd& values) {
  const Eigen::Index steps = values.size() - 1;
  double least = HUGE_VAL;
  for (Eigen::Index i = 0; i < steps; ++i) {
    const double difference = std::abs(values[i + 1] - values[i]);
    least = difference > 0.0 ? std::min(least, difference) : least;
  }
  return std::isfinite(least) ? least / std::sqrt(12.0) : 0.0;
}

}  // namespace

NoiseModel noiseOf(const log::Record& record, const Eigen::VectorXd& residual) {
  const double high = std::min(kHarmonics * record.highest_frequency * record.dt, kHighestEdge);
  return estimateNoise(record.withoutRig(residual), maskOf(record), {record.lowest_frequency * record.dt, high});
}

double noiseFloor(const log::Record& record, const Eigen::VectorXd& residual) {
  const Eigen::VectorXd left = record.withoutRig(residual);
  const double whole = std::sqrt(left.squaredNorm() / record.counted());
  const NoiseModel noise = noiseOf(record, residual);
  const double white = gap::whiteNoiseFloor(record, left) * record.force_deviation;
  const double floor = std::min(whole, noise.isColoured() ? std::max(noise.deviation, white) : white);
  return std::max(floor, std::min(whole, rounding(record.force))) / record.force_deviation;
}

}  // namespace rubber_suspension::measurement
