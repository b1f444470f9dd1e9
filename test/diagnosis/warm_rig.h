// The virtual rig at other temperatures: the test itself shifts rate and stiffness of a Zener solid.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "rig.h"

namespace rubber_suspension {

using TemperatureOf = std::function<double(double time)>;

// Computes the force of `runRig` for relaxation by WLF (natural rubber, 20 degC) and stiffness by T/T_0.
inline log::Log runAt(const std::string& name, unsigned seed, const TemperatureOf& temperature) {
  log::Log log = runRig(name, seed, nothing, 0.0);
  const auto elements = rigComponent().allElements();
  const double spring = elements[0].value("stiffness");
  const double stiffness = elements[1].value("stiffness");
  const double rate = 2.0 * element::kPi * elements[1].value("break_frequency");
  constexpr double kStep = 0.004;
  double relaxing = 0.0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double celsius = temperature(log.time(i));
    const double above = celsius - 20.0;
    const double shifted = rate * std::pow(10.0, 6.13 * above / (146.8 + above));
    const double decay = std::exp(-kStep * shifted);
    const double increment = i == 0 ? 0.0 : log.displacement[i] - log.displacement[i - 1];
    relaxing = decay * relaxing + stiffness * increment / (kStep * shifted) * (1.0 - decay);
    log.temperature.push_back(celsius);
    log.force[i] = (spring * log.displacement[i] + relaxing) * (celsius + 273.15) / 293.15;
  }
  addNoise(log.force, 10.0, seed);
  return log;
}

inline std::vector<log::Log> warmingLogs() {
  return {runAt("cold", 1, [](double time) { return 5.0 + 0.8 * time; }),
          runAt("warm", 2, [](double time) { return 35.0 + 0.5 * time; })};
}

inline log::Log unseenLog() {
  return runAt("unseen", 3, [](double time) { return 40.0 - 1.2 * time; });
}

}  // namespace rubber_suspension
