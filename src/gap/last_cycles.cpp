// The last cycles of a log.
#include "gap/last_cycles.h"

#include <cmath>
#include <numeric>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::gap {
namespace {

double secondsBetween(const log::Log& log, std::size_t first, std::size_t last) {
  return static_cast<double>(log.stamp[last] - log.stamp[first]) * 1e-9;
}

}  // namespace

double meanFrequency(const log::Log& log) {
  const auto size = static_cast<double>(log.size());
  const double mean = std::accumulate(log.displacement.begin(), log.displacement.end(), 0.0) / size;
  double displacement = 0.0;
  double speed = 0.0;
  for (std::size_t i = 1; i < log.size(); ++i) {
    const double step = secondsBetween(log, i - 1, i);
    displacement += std::pow(log.displacement[i] - mean, 2) * step;
    speed += std::pow(log.displacement[i] - log.displacement[i - 1], 2) / step;
  }
  return displacement > 0.0 ? std::sqrt(speed / displacement) / (2.0 * element::kPi) : 0.0;
}

std::size_t firstOfLastCycles(const log::Log& log, double frequency, double cycles) {
  std::size_t first = 0;
  while (frequency > 0.0 && first + 2 < log.size() && secondsBetween(log, first, log.size() - 1) > cycles / frequency) {
    ++first;
  }
  return first;
}

}  // namespace rubber_suspension::gap
