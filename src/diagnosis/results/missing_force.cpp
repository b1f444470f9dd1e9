// The missing force in cells of displacement and velocity.
#include "diagnosis/results/missing_force.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/hypotheses/workings.h"

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

io::Axes axesOf(const MissingForce& map, const std::vector<double>& force, const std::string& title) {
  io::Axes axes;
  axes.title = title;
  axes.x_label = "displacement [mm]";
  axes.y_label = "velocity [mm/s]";
  io::HeatMap heat;
  heat.label = "force [kN]";
  const auto scaled = [](const std::vector<double>& values, double factor) {
    std::vector<double> result(values.size());
    std::transform(values.begin(), values.end(), result.begin(), [&](double value) { return factor * value; });
    return result;
  };
  heat.x_edges = scaled(map.displacement, 1e3);
  heat.y_edges = scaled(map.velocity, 1e3);
  heat.values = scaled(force, 1e-3);
  axes.maps.push_back(std::move(heat));
  return axes;
}

}  // namespace

MissingForce missingForce(const Diagnosis& diagnosis) {
  const Workings& workings = *diagnosis.workings;
  MissingForce map;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const log::Record& record : workings.records) {
    low = std::min(low, record.displacement.minCoeff());
    high = std::max(high, record.displacement.maxCoeff());
  }
  map.displacement = evenEdges(low, high);
  const double speed = usualSpeed(workings.records);
  map.velocity = evenEdges(-speed, speed);
  map.measured.assign(kCells * kCells, 0.0);
  map.surrogate.assign(kCells * kCells, 0.0);
  map.samples.assign(kCells * kCells, 0);
  for (std::size_t r = 0; r < workings.records.size(); ++r) {
    addRecord(workings.records[r], workings.force_augmented[r], workings.force_surrogate[r], map);
  }
  for (std::size_t cell = 0; cell < map.samples.size(); ++cell) {
    const double count = map.samples[cell] < kFewestSamples ? std::numeric_limits<double>::quiet_NaN()
                                                            : static_cast<double>(map.samples[cell]);
    map.measured[cell] /= count;
    map.surrogate[cell] /= count;
  }
  return map;
}

std::string toCsv(const MissingForce& map) {
  std::string text = "displacement_m,velocity_m_per_s,missing_force_N,surrogate_force_N,samples\n";
  for (std::size_t cell = 0; cell < map.samples.size(); ++cell) {
    if (std::isnan(map.measured[cell])) {
      continue;
    }
    const std::size_t x = cell % kCells;
    const std::size_t y = cell / kCells;
    text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{}\n", 0.5 * (map.displacement[x] + map.displacement[x + 1]),
                        0.5 * (map.velocity[y] + map.velocity[y + 1]), map.measured[cell], map.surrogate[cell],
                        map.samples[cell]);
  }
  return text;
}

io::Figure missingForceFigure(const MissingForce& map) {
  io::Figure figure;
  figure.title = "Force that the model lacks, over displacement and velocity";
  figure.axes.push_back(axesOf(map, map.measured, "measured less augmented"));
  figure.axes.push_back(axesOf(map, map.surrogate, "what the surrogate adds"));
  return figure;
}

}  // namespace rubber_suspension::diagnosis::results
