// A small virtual rig for tests: a Zener solid integrated exactly, effects and noise written out by hand.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension {

/// The component of all test rigs: M2 with K_st = 1e6 N/m, K_n = 1.3e6 N/m at 4 Hz, f_b = 3 Hz.
inline io::ComponentDescription rigComponent() {
  return io::parseComponentFile(
             "components:\n  bush:\n    model: maxwell\n    specification:\n      static_stiffness: 1.0e6\n"
             "      dynamic_stiffness: 1.3e6\n      nominal_frequency: 4.0\n      break_frequency: 3.0\n",
             "rig")
      .front();
}

/// What a rig does besides the component's own force; [N] of time [s], displacement [m] and rate [m/s].
using RigEffect = std::function<double(double time, double displacement, double rate)>;

/// Friction that remembers where it turned: one for each log.
inline RigEffect rigFriction() {
  return [force = 0.0, last = 0.0](double time, double z, double /*rate*/) mutable {
    force = time == 0.0 ? 0.0 : std::clamp(force + 1.2e6 * (z - last), -150.0, 150.0);
    last = z;
    return force;
  };
}

/// A log of 20 s at 250 Hz: a sine whose amplitude and frequency go through their ranges without a jump.
inline log::Log runRig(const std::string& name, unsigned seed, const RigEffect& effect, double noise = 20.0) {
  constexpr double kStep = 0.004;
  constexpr int kSamples = 5000;
  const auto elements = rigComponent().allElements();
  double spring = 0.0;
  double stiffness = 0.0;
  double frequency = 0.0;
  for (const auto& element : elements) {
    if (element.type == "spring") {
      spring = element.value("stiffness");
    } else {
      stiffness = element.value("stiffness");
      frequency = element.value("break_frequency");
    }
  }
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, noise);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double phase = 2.0 * element::kPi * uniform(generator);
  log::Log log;
  log.name = name;
  double relaxing = 0.0;
  double before = 0.0;
  const double decay = std::exp(-kStep * 2.0 * element::kPi * frequency);
  for (int i = 0; i < kSamples; ++i) {
    const double time = kStep * i;
    const double amplitude = 0.0011 + 0.0009 * std::sin(0.7 * time + static_cast<double>(seed));
    const double f = 3.5 + 2.8 * std::sin(0.45 * time + 2.0 * static_cast<double>(seed));
    phase += 2.0 * element::kPi * f * kStep;
    const double z = amplitude * std::sin(phase);
    if (i == 0) {
      before = z;
    }
    relaxing = decay * relaxing + stiffness * (z - before) / (kStep * 2.0 * element::kPi * frequency) * (1.0 - decay);
    const double rate = amplitude * 2.0 * element::kPi * f * std::cos(phase);
    log.stamp.push_back(static_cast<std::int64_t>(i) * 4000000);
    log.displacement.push_back(z);
    log.force.push_back(spring * z + relaxing + effect(time, z, rate) + normal(generator));
    before = z;
  }
  return log;
}

}  // namespace rubber_suspension
