// The error of a model with Berg's friction due to small reversals and to unknown motion before a log.
#include "measurement/friction_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gap/simulate.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::measurement {
namespace {

// Returns Berg's friction of a model with its dead band (if 0, 4 times the sensor's noise) multiplied by a factor.
std::vector<element::ElementDescription> bergFriction(const std::vector<element::ElementDescription>& elements,
                                                      double noise, double dead_band_factor) {
  constexpr double kOfNoise = 4.0;
  std::vector<element::ElementDescription> result;
  for (const element::ElementDescription& element : elements) {
    if (element.type == "friction") {
      result.push_back(element::complete(element));
      double& dead_band = result.back().values.at("dead_band").front();
      dead_band = dead_band_factor * (dead_band > 0.0 ? dead_band : kOfNoise * noise);
    }
  }
  return result;
}

// Returns the record after a motion from rest to a displacement and on to the record's first one. These three points
// suffice, because Berg's friction depends on turning points and not on the rate.
log::Record cameFrom(log::Record record, double displacement) {
  record.lead_in = {record.dt, {0.0, displacement, record.displacement[0]}, false};
  return record;
}

}  // namespace

std::vector<double> frictionNoise(const std::vector<element::ElementDescription>& elements,
                                  const std::vector<gap::PreparedRecord>& records) {
  constexpr std::array<double, 3> kVariants = {0.7, 1.0, 1.4};  // factors of the dead band
  double noise = 0.0;
  for (const log::Record& record : records) {
    noise = std::max(noise, record.displacement_noise);
  }
  std::vector<double> result(records.size(), 0.0);
  const auto friction = bergFriction(elements, noise, 1.0);
  if (friction.empty()) {
    return result;
  }
  const auto plain = gap::simulate(friction, records);
  unsigned draw = 0;
  for (const double factor : kVariants) {
    ++draw;
    const auto noisy = gap::simulate(bergFriction(elements, noise, factor), records,
                                     [draw](const log::Record& record) { return log::withNoiseDrawn(record, draw); });
    for (std::size_t r = 0; r < plain.size(); ++r) {
      result[r] += (noisy[r] - plain[r]).squaredNorm() / static_cast<double>(records[r].size()) / kVariants.size();
    }
  }
  for (std::size_t r = 0; r < result.size(); ++r) {
    result[r] = std::sqrt(result[r]) / records[r].force_deviation;
  }
  return result;
}

std::vector<Eigen::MatrixXd> frictionStarts(const std::vector<element::ElementDescription>& elements,
                                            const std::vector<gap::PreparedRecord>& records) {
  std::vector<Eigen::MatrixXd> starts(records.size());
  const auto friction = bergFriction(elements, 0.0, 1.0);
  for (std::size_t r = 0; r < records.size(); ++r) {
    const log::Record& record = records[r];
    starts[r].resize(record.size(), 0);
    if (friction.empty() || !record.lead_in.displacement.empty()) {
      continue;  // the motion before an excerpt is known
    }
    const Eigen::VectorXd from_rest = gap::simulate(friction, {record}).front();
    starts[r].resize(record.size(), 2);
    starts[r].col(0) = gap::simulate(friction, {cameFrom(record, record.displacement.maxCoeff())}).front() - from_rest;
    starts[r].col(1) = gap::simulate(friction, {cameFrom(record, record.displacement.minCoeff())}).front() - from_rest;
    starts[r].rowwise() -= starts[r].colwise().mean().eval();
  }
  return starts;
}

}  // namespace rubber_suspension::measurement
