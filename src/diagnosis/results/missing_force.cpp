// The missing force in cells of displacement and velocity.
#include "diagnosis/results/missing_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr std::size_t kCells = 32;  // along each axis
constexpr int kFewestSamples = 5;   // in a cell
constexpr double kFastest = 0.995;  // share of samples within the map: single fast ones would stretch it
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

// The speed that all but a few samples stay below.
double usualSpeed(const std::vector<log::Record>& records) {
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

MissingForce missingForce(const std::vector<log::Record>& records, const gap::Forces& augmented,
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
