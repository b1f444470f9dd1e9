// Finds the last cycles of a log.
#include "gap/last_cycles.h"

#include <cmath>
#include <numeric>

namespace rubber_suspension::gap {

std::vector<std::size_t> meanCrossings(const log::Log& log) {
  constexpr double kHysteresis = 0.25;  // share of the standard deviation, against noise of the sensor
  const auto size = static_cast<double>(log.size());
  const double mean = std::accumulate(log.displacement.begin(), log.displacement.end(), 0.0) / size;
  double variance = 0.0;
  for (const double z : log.displacement) {
    variance += std::pow(z - mean, 2) / size;
  }
  const double band = kHysteresis * std::sqrt(variance);
  int side = 0;
  std::vector<std::size_t> crossings;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double z = log.displacement[i];
    const int now = z > mean + band ? 1 : z < mean - band ? -1 : side;
    if (side != 0 && now != side) {
      crossings.push_back(i);
    }
    side = now;
  }
  return crossings;
}

double meanFrequency(const log::Log& log) {
  const double duration = log.duration(0, log.size() - 1);
  return duration > 0.0 ? 0.5 * static_cast<double>(meanCrossings(log).size()) / duration : 0.0;
}

std::size_t firstOfLastCycles(const log::Log& log, double frequency, double cycles) {
  std::size_t first = 0;
  while (frequency > 0.0 && first + 2 < log.size() && log.duration(first, log.size() - 1) > cycles / frequency) {
    ++first;
  }
  return first;
}

}  // namespace rubber_suspension::gap
