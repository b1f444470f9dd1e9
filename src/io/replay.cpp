// Simulates a component on a recorded log, offline.
#include "rubber_suspension/io/replay.h"

#include <fmt/format.h>

#include <cmath>

#include "rubber_suspension/io/progress.h"

namespace rubber_suspension {

std::vector<double> simulateLog(const Component& component, const Log& log, StreamCounters* counters) {
  checkLog(log);
  SampleStream stream(component);
  Progress progress("simulating " + log.name, log.size());
  std::vector<double> force;
  force.reserve(log.size());
  for (std::size_t i = 0; i < log.size(); ++i) {
    const StreamForce result = stream.push(log.stamp[i], log.displacement[i]);
    // The log is checked, so every sample is accepted; a force may still be too large for a double.
    if (!std::isfinite(result.force.total)) {
      throw LogError(fmt::format("{}: sample {}: displacement {:g} m gives a force that is not finite", log.name, i + 1,
                                 log.displacement[i]));
    }
    force.push_back(result.force.total);
    progress.advance();
  }
  if (counters != nullptr) {
    *counters = stream.counters();
  }
  return force;
}

}  // namespace rubber_suspension
