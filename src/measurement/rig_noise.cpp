// Noise of one rig.
#include "measurement/rig_noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "numerics/median.h"

namespace rubber_suspension::measurement {

double ErrorScale::oneDeviation(double floor, std::size_t logs) const {
  return std::hypot(accepted, floor_known * floor) * std::sqrt(static_cast<double>(logs) / sharpness);
}

double NoiseLimit::of(const log::Record& record) const { return std::max(force / record.force_deviation, share); }

NoiseLimit noiseLimit(const std::vector<double>& noise, const std::vector<gap::PreparedRecord>& records) {
  constexpr double kScatter = 1.5;
  std::vector<double> forces;
  for (std::size_t r = 0; r < noise.size(); ++r) {
    forces.push_back(noise[r] * records[r].force_deviation);
  }
  return {kScatter * numerics::medianOf(forces), kScatter * numerics::medianOf(noise)};
}

// The squares of the values of the rig's errors sum up to r'(I + C C')^-1 r - |(I + C C')^-1 r|^2 for a residual r.
double rigCost(const gap::PreparedRecord& record, const Eigen::VectorXd& residual) {
  if (record.rig.columns.cols() == 0) {
    return 0.0;
  }
  const Eigen::VectorXd white = record.withoutRig(residual);
  const double squares = white.squaredNorm() - record.withoutRig(white).squaredNorm();
  const double cost = std::sqrt(std::max(0.0, squares) / record.counted()) / record.force_deviation;
  constexpr double kWithin = 0.95;
  const boost::math::chi_squared values(static_cast<double>(record.rig.columns.cols()));
  return std::min(cost, record.rig.one_deviation * std::sqrt(boost::math::quantile(values, kWithin)));
}

std::vector<LogWeight> weightsByNoise(const std::vector<double>& noise, double accepted) {
  if (noise.empty()) {
    return {};
  }
  const double most = std::max(accepted, *std::min_element(noise.begin(), noise.end()));
  std::vector<LogWeight> weights(noise.size());
  double sum = 0.0;
  for (std::size_t r = 0; r < noise.size(); ++r) {
    auto& [weight, note] = weights[r];
    weight = std::pow(std::min(1.0, most / noise[r]), 2);
    sum += weight;
    if (weight < 1.0) {
      note = fmt::format(
          "the noise that the model does not explain is {:.2g} % of the force; this log has {:.2g} times the weight of "
          "other logs",
          100.0 * noise[r], weight);
    }
  }
  for (LogWeight& one : weights) {
    one.weight *= static_cast<double>(weights.size()) / sum;
  }
  return weights;
}

}  // namespace rubber_suspension::measurement
