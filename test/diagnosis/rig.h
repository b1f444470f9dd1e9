// A small virtual rig for tests: an exactly integrated Zener solid, with handwritten effects and noise.
#pragma once

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"
#include "support/kit.h"

namespace rubber_suspension {

constexpr double kOneDeviation = 0.002;  ///< gap that counts as much as a departure of one standard deviation

/// Returns the Zener solid of all test rigs.
inline io::ComponentDescription rigComponent() {
  return componentOf(
      "components:\n  bush:\n    model: maxwell\n    specification:\n      static_stiffness: 1.0e6\n"
      "      dynamic_stiffness: 1.3e6\n      nominal_frequency: 4.0\n      break_frequency: 3.0\n");
}

/// Force [N] that an effect adds to the force of the component, from time [s], displacement [m] and rate [m/s].
using RigEffect = std::function<double(double time, double displacement, double rate)>;

inline double nothing(double /*time*/, double /*displacement*/, double /*rate*/) { return 0.0; }

/// Returns an effect that depends on the steps of the displacement [m] and starts anew at time 0 of each log.
inline RigEffect ofSteps(const std::function<double(double step)>& law) {
  return [law, running = law, last = 0.0](double time, double z, double /*rate*/) mutable {
    if (time == 0.0) {
      running = law;
      last = z;
    }
    const double step = z - last;
    last = z;
    return running(step);
  };
}

/// Friction with hysteresis: an elastic slider of 1.2e6 N/m that slips at 150 N.
inline RigEffect rigFriction() {
  return ofSteps(
      [force = 0.0](double step) mutable { return force = std::clamp(force + 1.2e6 * step, -150.0, 150.0); });
}

/// Returns displacement [m] and rate [m/s] at a time [s]. It is called once per sample, in order.
using RigMotion = std::function<std::pair<double, double>(double time)>;

/// Records 5000 samples of a motion with a time step [s] and noise of a standard deviation [N].
inline log::Log runMotion(const std::string& name, std::mt19937& generator, const RigMotion& motion,
                          const RigEffect& effect, double noise, double step) {
  constexpr int kSamples = 5000;
  const auto elements = rigComponent().allElements();
  const double spring = elements[0].value("stiffness");
  const double stiffness = elements[1].value("stiffness");
  const double frequency = elements[1].value("break_frequency");
  std::normal_distribution<double> normal(0.0, noise);
  log::Log log;
  log.name = name;
  double relaxing = 0.0;
  double before = 0.0;
  const double decay = std::exp(-step * 2.0 * element::kPi * frequency);
  for (int i = 0; i < kSamples; ++i) {
    const double time = step * i;
    const auto [z, rate] = motion(time);
    if (i == 0) {
      before = z;
    }
    relaxing = decay * relaxing + stiffness * (z - before) / (step * 2.0 * element::kPi * frequency) * (1.0 - decay);
    log.stamp.push_back(static_cast<std::int64_t>(i) * std::llround(step * 1e9));
    log.displacement.push_back(z);
    log.force.push_back(spring * z + relaxing + effect(time, z, rate) + normal(generator));
    before = z;
  }
  return log;
}

/// Records 20 s at 250 Hz of a sine whose amplitude and frequency vary continuously.
inline log::Log runRig(const std::string& name, unsigned seed, const RigEffect& effect, double noise = 20.0) {
  constexpr double kStep = 0.004;
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double phase = 2.0 * element::kPi * uniform(generator);
  const auto motion = [&](double time) {
    const double amplitude = 0.0011 + 0.0009 * std::sin(0.7 * time + static_cast<double>(seed));
    const double f = 3.5 + 2.8 * std::sin(0.45 * time + 2.0 * static_cast<double>(seed));
    phase += 2.0 * element::kPi * f * kStep;
    return std::make_pair(amplitude * std::sin(phase), amplitude * 2.0 * element::kPi * f * std::cos(phase));
  };
  return runMotion(name, generator, motion, effect, noise, kStep);
}

/// Returns one log of `runRig` per seed.
inline std::vector<log::Log> runRigs(const std::vector<unsigned>& seeds, const RigEffect& effect, double noise = 20.0) {
  std::vector<log::Log> logs;
  for (const unsigned seed : seeds) {
    logs.push_back(runRig("log " + std::to_string(seed), seed, effect, noise));
  }
  return logs;
}

}  // namespace rubber_suspension
