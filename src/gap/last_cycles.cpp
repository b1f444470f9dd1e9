// The last cycles of a log.
#include "gap/last_cycles.h"

#include <cmath>
#include <numeric>

namespace rubber_suspension::gap {

double meanFrequency(const log::Log& log) {
  constexpr double kHysteresis = 0.25;  // of the standard deviation, against noise of the sensor
  const auto size = static_cast<double>(log.size());
  const double mean = std::accumulate(log.displacement.begin(), log.displacement.end(), 0.0) / size;
  double variance = 0.0;
  for (const double z : log.displacement) {
    variance += std::pow(z - mean, 2) / size;
  }
  const double band = kHysteresis * std::sqrt(variance);
  int side = 0;
  int crossings = 0;
  for (const double z : log.displacement) {
    const int now = z > mean + band ? 1 : z < mean - band ? -1 : side;
    crossings += side != 0 && now != side ? 1 : 0;
    side = now;
  }
  const double duration = log.duration(0, log.size() - 1);
  return duration > 0.0 ? 0.5 * crossings / duration : 0.0;
}

std::size_t firstOfLastCycles(const log::Log& log, double frequency, double cycles) {
  std::size_t first = 0;
  while (frequency > 0.0 && first + 2 < log.size() && log.duration(first, log.size() - 1) > cycles / frequency) {
    ++first;
  }
  return first;
}

}  // namespace rubber_suspension::gap
