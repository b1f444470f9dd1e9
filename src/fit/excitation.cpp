// Summary of the motion and force of logs.
#include "fit/excitation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "gap/simulate.h"
#include "numerics/quantile.h"

namespace rubber_suspension::fit {

namespace {

// Distance between the limits of white noise that a million samples do not exceed.
constexpr double kDeadBandOfNoise = 10.0;  // in standard deviations

// Rounds to the two digits with which a component file states the value.
double inTwoDigits(double value) { return std::stod(fmt::format("{:.2g}", value)); }

void addTemperature(const std::vector<gap::PreparedRecord>& records, Excitation& result) {
  result.has_temperature = std::all_of(records.begin(), records.end(),
                                       [](const log::Record& record) { return record.temperature.size() > 0; });
  if (!result.has_temperature || records.empty()) {
    return;
  }
  result.lowest_temperature = result.highest_temperature = records.front().temperature[0];
  for (const log::Record& record : records) {
    result.lowest_temperature = std::min(result.lowest_temperature, record.temperature.minCoeff());
    result.highest_temperature = std::max(result.highest_temperature, record.temperature.maxCoeff());
  }
}

void addForces(const std::vector<gap::PreparedRecord>& records, Excitation& result) {
  constexpr double kBeyond = 1e-3;
  for (const log::Record& record : records) {
    std::vector<double> force(record.force.begin(), record.force.end());
    std::sort(force.begin(), force.end());
    result.lowest_force = std::min(result.lowest_force, numerics::quantileOf(force, kBeyond));
    result.highest_force = std::max(result.highest_force, numerics::quantileOf(force, 1.0 - kBeyond));
  }
}

// Returns the largest radius, or 0 unless all logs have a transverse displacement independent of the axial one.
double largestRadius(const std::vector<gap::PreparedRecord>& records) {
  constexpr double kLeastApart = 0.2;  // share of the axial motion
  double largest = 0.0;
  double squares = 0.0;  // sum of squares of the part that does not follow the axial motion
  double own = 0.0;
  for (const log::Record& record : records) {
    if (record.across.size() == 0) {
      return 0.0;
    }
    const Eigen::ArrayXd z = record.displacement.array();
    const Eigen::ArrayXd across = record.across.array();
    const Eigen::ArrayXd centred = z - z.mean();
    const Eigen::ArrayXd other = across - across.mean();
    const double slope = (centred * other).sum() / centred.square().sum();
    squares += (other - slope * centred).square().sum();
    own += centred.square().sum();
    largest = std::max(largest, std::sqrt((z.square() + across.square()).maxCoeff()));
  }
  return squares > kLeastApart * kLeastApart * own ? largest : 0.0;
}

// Returns the error of the force of a mass of 1 kg if it is computed, as in the node, without later samples: the sum
// over the logs of the mean square, relative to the force. The first twentieth of a log may have a jerk and is skipped.
double errorInTime(const std::vector<gap::PreparedRecord>& records, double bandwidth) {
  const auto in_time =
      gap::simulate({{"inertia", {{"mass", {1.0}}, {"bandwidth", {bandwidth}}}}}, records, gap::asRecorded);
  double sum = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Eigen::Index settled = records[r].size() - records[r].size() / 20;
    const Eigen::VectorXd error = (in_time[r] - acceleration(records[r])).tail(settled) / records[r].force_deviation;
    sum += error.squaredNorm() / static_cast<double>(settled);
  }
  return sum;
}

}  // namespace

Eigen::VectorXd acceleration(const log::Record& record) {
  const Eigen::Index inner = record.size() - 2;
  const Eigen::VectorXd& z = record.displacement;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(record.size());
  result.segment(1, inner) = (z.head(inner) - 2.0 * z.segment(1, inner) + z.tail(inner)) / (record.dt * record.dt);
  return result;
}

double massBandwidth(const std::vector<gap::PreparedRecord>& records, double highest_frequency) {
  double best = 0.0;
  double least = errorInTime(records, best);
  for (const double multiple : {1.0, 1.5, 2.2, 3.3, 5.0, 7.5, 11.0, 16.0}) {
    const double bandwidth = multiple * highest_frequency;
    const double error = errorInTime(records, bandwidth);
    if (error < least) {
      least = error;
      best = bandwidth;
    }
  }
  return best;
}

Excitation summarise(const std::vector<gap::PreparedRecord>& records) {
  Excitation result;
  const bool whole = std::none_of(records.begin(), records.end(),
                                  [](const log::Record& record) { return !record.lead_in.displacement.empty(); });
  result.whole_logs = whole ? records.size() : 0;
  double force_power = 0.0;
  double displacement_power = 0.0;
  const auto grow = [](double& largest, double value) { largest = std::max(largest, value); };
  for (const gap::PreparedRecord& record : records) {
    result.own = {result.own.gain || record.own.gain, result.own.zero || record.own.zero};
    const Eigen::VectorXd& z = record.displacement;
    const Eigen::Index steps = record.size() - 1;
    const Eigen::ArrayXd rate = (z.tail(steps) - z.head(steps)).array() / record.dt;
    const double highest_rate = rate.abs().maxCoeff();
    grow(result.largest_displacement, z.cwiseAbs().maxCoeff());
    grow(result.highest_frequency, record.highest_frequency);
    grow(result.mean_frequency, record.mean_frequency);
    grow(result.highest_rate, highest_rate);
    grow(result.slowest_loop, 0.5 * (z.maxCoeff() - z.minCoeff()) / highest_rate);
    grow(result.longest_duration, record.duration());
    grow(result.dt, record.dt);
    grow(result.dead_band, inTwoDigits(kDeadBandOfNoise * record.displacement_noise));
    grow(result.power, (rate * record.force.tail(steps).array()).abs().mean());
    grow(result.force, record.force_deviation);
    force_power += std::pow(record.force_deviation, 2) * static_cast<double>(record.size());
    displacement_power += (z.array() - z.mean()).square().sum();
  }
  result.stiffness = std::sqrt(force_power / displacement_power);
  addForces(records, result);
  addTemperature(records, result);
  result.largest_radius = largestRadius(records);
  result.mass_bandwidth = massBandwidth(records, result.highest_frequency);
  return result;
}

}  // namespace rubber_suspension::fit
