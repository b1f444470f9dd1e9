// Fits and judges a surrogate for the residual force.
#include "diagnosis/results/surrogate.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr double kChanceOfGain = 0.05;  // significance level of an improvement on unseen blocks
constexpr double kEvenChance = 0.5;     // returned if the blocks do not determine the probability
constexpr double kLargerPart = 0.5;     // least predicted share of a residual that is a function of the motion
constexpr std::size_t kFewestLogs = 3;  // least number of logs from which the scatter between logs is estimated

// Appends the tenths of held-out logs, which no fit has used and which count as further logs.
void addHeldOut(const io::ComponentDescription& component, const io::ComponentDescription& with_surrogate,
                const std::vector<gap::PreparedRecord>& held_out, int first, std::vector<fit::UnseenBlock>& unseen) {
  for (std::size_t r = 0; r < held_out.size(); ++r) {
    const std::vector<gap::PreparedRecord> one = {held_out[r]};
    const auto before = gap::partErrors(one, gap::simulateEach(component.allElements(), one));
    const auto after = gap::partErrors(one, gap::simulateEach(with_surrogate.allElements(), one));
    for (std::size_t p = 0; p < before.size(); ++p) {
      unseen.push_back({first + static_cast<int>(r), before[p].weight, before[p].error, after[p].error});
    }
  }
}

// Returns half the logarithm of the ratio of the squared errors after and before. The squared noise is added to both,
// so that only the error above the noise counts. The result is negative if the surrogate reduces the error.
double gainOf(const fit::UnseenBlock& block, double noise_floor) {
  const double noise = noise_floor * noise_floor;
  return 0.5 * std::log((block.after + noise) / (block.before + noise));
}

// Returns the probability that the mean improvement occurs by chance, with Student's t over logs, or over blocks if
// there are few logs. The standard error is that of a weighted mean over clusters (Cameron and Miller, J. Human
// Resources 50, 2015, Eq. 11), because blocks of one log are not independent.
double chanceOf(const std::vector<fit::UnseenBlock>& unseen, double noise_floor, bool count_logs) {
  double weight = 0.0;
  double mean = 0.0;
  for (const fit::UnseenBlock& block : unseen) {
    weight += block.weight;
    mean += block.weight * gainOf(block, noise_floor);
  }
  mean /= weight;
  std::map<int, double> departs;  // weighted sum of deviations from the mean in each cluster
  for (std::size_t b = 0; b < unseen.size(); ++b) {
    departs[count_logs ? unseen[b].record : static_cast<int>(b)] +=
        unseen[b].weight * (gainOf(unseen[b], noise_floor) - mean);
  }
  const auto clusters = static_cast<double>(departs.size());
  const double squares = std::accumulate(departs.begin(), departs.end(), 0.0,
                                         [](double sum, const auto& one) { return sum + one.second * one.second; });
  if (clusters < 2.0 || !std::isfinite(squares)) {
    return kEvenChance;
  }
  const double error = std::sqrt(clusters / (clusters - 1.0) * squares) / weight;
  return error > 0.0 ? boost::math::cdf(boost::math::students_t(clusters - 1.0), mean / error) : mean < 0.0 ? 0.0 : 1.0;
}

constexpr std::size_t kCells = 32;  // number of cells along each axis of the map
constexpr int kFewestSamples = 5;   // least number of samples in a cell with a value
constexpr double kFastest = 0.995;  // share of samples within the map; a few fast samples would stretch the map
constexpr std::size_t kVelocitySamples = 20000;

std::vector<double> evenEdges(double low, double high) {
  std::vector<double> edges(kCells + 1);
  for (std::size_t i = 0; i <= kCells; ++i) {
    edges[i] = low + (high - low) * static_cast<double>(i) / static_cast<double>(kCells);
  }
  return edges;
}

double velocityOf(const log::Record& record, Eigen::Index i) {
  return (record.displacement[i + 1] - record.displacement[i - 1]) / (2.0 * record.dt);
}

// Returns the speed below which all but a few samples lie.
double usualSpeed(const std::vector<gap::PreparedRecord>& records) {
  std::vector<double> speeds;
  for (const log::Record& record : records) {
    const Eigen::Index stride = 1 + record.size() / static_cast<Eigen::Index>(kVelocitySamples);
    for (Eigen::Index i = 1; i + 1 < record.size(); i += stride) {
      speeds.push_back(std::abs(velocityOf(record, i)));
    }
  }
  const auto place = speeds.begin() + static_cast<std::ptrdiff_t>(kFastest * static_cast<double>(speeds.size() - 1));
  std::nth_element(speeds.begin(), place, speeds.end());
  return *place;
}

std::size_t cellOf(double value, const std::vector<double>& edges) {
  const double share = (value - edges.front()) / (edges.back() - edges.front());
  return static_cast<std::size_t>(std::clamp(share * kCells, 0.0, kCells - 1.0));
}

void addRecord(const log::Record& record, const Eigen::VectorXd& augmented, const Eigen::VectorXd& surrogate,
               MissingForce& map) {
  for (Eigen::Index i = 1; i + 1 < record.size(); ++i) {
    const double velocity = velocityOf(record, i);
    if ((record.counts.size() > 0 && record.counts[i] == 0.0) || std::abs(velocity) > map.velocity.back()) {
      continue;
    }
    const std::size_t cell = kCells * cellOf(velocity, map.velocity) + cellOf(record.displacement[i], map.displacement);
    map.measured[cell] += record.force[i] - augmented[i];
    map.surrogate[cell] += surrogate[i] - augmented[i];
    ++map.samples[cell];
  }
}

}  // namespace

void judgeRest(const std::vector<fit::UnseenBlock>& unseen, double noise_floor, bool count_logs, Surrogate& surrogate) {
  double weight = 0.0;
  double before = 0.0;
  double after = 0.0;
  for (const fit::UnseenBlock& block : unseen) {
    weight += block.weight;
    before += block.weight * block.before;
    after += block.weight * block.after;
  }
  surrogate.unseen_before = std::sqrt(before / weight);
  surrogate.unseen_after = std::sqrt(after / weight);
  // The residual in unseen blocks includes the noise. A noise floor above this residual is therefore wrong.
  const double floor = noise_floor < surrogate.unseen_after ? noise_floor : 0.0;
  const double rest = gap::residualAboveFloor(surrogate.unseen_before, floor);
  const double left = gap::residualAboveFloor(surrogate.unseen_after, floor);
  surrogate.share = rest > 0.0 ? std::clamp(1.0 - std::pow(left / rest, 2), 0.0, 1.0) : 0.0;
  surrogate.chance = chanceOf(unseen, noise_floor, count_logs);
  surrogate.beyond_chance = surrogate.chance < kChanceOfGain;
  surrogate.function_of_the_motion = surrogate.beyond_chance && surrogate.share > kLargerPart;
}

Surrogate fitSurrogate(const io::ComponentDescription& component, const SurrogateLogs& logs, double noise_floor,
                       int threads) {
  const fit::SurrogateFit fit = fit::fitSurrogate(logs.training, logs.force, threads);
  Surrogate surrogate;
  surrogate.component = component;
  surrogate.component.add.push_back(fit.element);
  std::vector<fit::UnseenBlock> unseen;
  std::copy_if(fit.unseen.begin(), fit.unseen.end(), std::back_inserter(unseen),
               [](const fit::UnseenBlock& block) { return block.weight > 0.0; });
  const double share = static_cast<double>(logs.training.size());
  for (fit::UnseenBlock& block : unseen) {  // each log counts 1, like the held-out logs
    block.weight *= share;
    block.after = fit.predicts ? block.after : block.before;
  }
  addHeldOut(component, surrogate.component, logs.held_out, static_cast<int>(logs.training.size()), unseen);
  judgeRest(unseen, noise_floor, logs.training.size() + logs.held_out.size() >= kFewestLogs, surrogate);
  return surrogate;
}

MissingForce missingForce(const std::vector<gap::PreparedRecord>& records, const gap::Forces& augmented,
                          const gap::Forces& surrogate) {
  MissingForce map;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const log::Record& record : records) {
    low = std::min(low, record.displacement.minCoeff());
    high = std::max(high, record.displacement.maxCoeff());
  }
  map.displacement = evenEdges(low, high);
  const double speed = usualSpeed(records);
  map.velocity = evenEdges(-speed, speed);
  map.measured.assign(kCells * kCells, 0.0);
  map.surrogate.assign(kCells * kCells, 0.0);
  map.samples.assign(kCells * kCells, 0);
  for (std::size_t r = 0; r < records.size(); ++r) {
    addRecord(records[r], augmented[r], surrogate[r], map);
  }
  for (std::size_t cell = 0; cell < map.samples.size(); ++cell) {
    const double count = map.samples[cell] < kFewestSamples ? std::numeric_limits<double>::quiet_NaN()
                                                            : static_cast<double>(map.samples[cell]);
    map.measured[cell] /= count;
    map.surrogate[cell] /= count;
  }
  return map;
}

}  // namespace rubber_suspension::diagnosis::results
