// Functions that make elements, components, logs and settled sines for tests.
#pragma once

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"
#include "support/test.h"

namespace rubber_suspension {

using Entries = std::vector<element::ElementDescription>;

/// Parses an entry of type, keys and values, such as "iwan_table yield_displacement=1e-4,5e-4 stiffness=2e6,1e6".
inline element::ElementDescription entry(const std::string& text) {
  std::istringstream words(text);
  element::ElementDescription description;
  words >> description.type;
  for (std::string word; words >> word;) {
    std::vector<double>& values = description.values[word.substr(0, word.find('='))];
    std::istringstream numbers(word.substr(word.find('=') + 1));
    for (std::string number; std::getline(numbers, number, ',');) {
      values.push_back(std::stod(number));
    }
  }
  return description;
}

/// Parses an entry and adds parameters with values that the test computes.
inline element::ElementDescription entry(const std::string& text,
                                         const std::vector<std::pair<std::string, double>>& more) {
  element::ElementDescription description = entry(text);
  for (const auto& [key, value] : more) {
    description.values[key] = {value};
  }
  return description;
}

inline Entries operator+(Entries entries, const Entries& more) {
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

inline element::ElementDescription spring(double stiffness /* [N/m] */) {
  return {"spring", {{"stiffness", {stiffness}}}};
}

inline element::ElementDescription dashpot(double damping /* [N s/m] */) {
  return {"dashpot", {{"damping", {damping}}}};
}

inline element::ElementDescription maxwell(double stiffness /* [N/m] */, double break_frequency /* [Hz] */) {
  return {"maxwell", {{"stiffness", {stiffness}}, {"break_frequency", {break_frequency}}}};
}

/// Returns Berg's friction with a maximum force [N], half of which it reaches at `displacement` [m].
inline element::ElementDescription friction(double maximum_force, double displacement) {
  return {"friction", {{"maximum_force", {maximum_force}}, {"displacement", {displacement}}}};
}

inline element::ElementDescription friction(double maximum_force, double displacement, double dead_band) {
  element::ElementDescription element = friction(maximum_force, displacement);
  element.values["dead_band"] = {dead_band};
  return element;
}

/// A component with its state, for tests of its total force [N].
struct WithState : component::Component {
  using component::Component::Component;
  component::ComponentState state = makeState();

  double step(double dt, double displacement) { return Component::step(state, dt, displacement).total; }
  double initialise(double displacement) { return Component::initialise(state, displacement).total; }
  double relax(double displacement) { return Component::relax(state, displacement).total; }
};

/// Returns the first harmonic of the force divided by that of the displacement [N/m], in the last of `cycles` cycles of
/// a sine with an amplitude [m] and a frequency [Hz]. `step` takes a time step [s] and a displacement [m], and returns
/// the force [N].
template <class Step>
std::complex<double> settledStiffness(double frequency, int samples, int cycles, double amplitude, const Step& step) {
  std::complex<double> sum = 0.0;
  for (int i = 1; i <= cycles * samples; ++i) {
    const double phase = 2.0 * element::kPi * (i % samples) / samples;
    const double force = step(1.0 / (frequency * samples), amplitude * std::sin(phase));
    sum += i > (cycles - 1) * samples ? force * std::polar(1.0, -phase) : 0.0;
  }
  return sum * std::complex<double>(0.0, 2.0 / (amplitude * samples));
}

inline std::complex<double> settledStiffness(const component::Component& component, double frequency, int samples,
                                             int cycles, double amplitude = 1e-3) {
  component::ComponentState state = component.makeState();
  return settledStiffness(frequency, samples, cycles, amplitude, [&](double dt, double displacement) {
    return component.step(state, dt, displacement).total;
  });
}

/// Returns the first component of a component file. Throws ComponentFileError.
inline io::ComponentDescription componentOf(const std::string& text, const std::string& file = "test") {
  return io::parseComponentFile(text, file).at(0);
}

/// Adds white noise with a standard deviation.
inline void addNoise(std::vector<double>& values, double deviation, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, deviation);
  for (double& value : values) {
    value += normal(generator);
  }
}

/// Returns a log with a time step `interval` [ns]. Its displacement [m] is a function of the index of the sample.
template <class Displacement>
log::Log logOf(const std::string& name, int samples, std::int64_t interval, const Displacement& displacement) {
  log::Log log;
  log.name = name;
  for (int i = 0; i < samples; ++i) {
    log.stamp.push_back(i * interval);
    log.displacement.push_back(displacement(i));
  }
  return log;
}

/// Returns such a log with a force [N] that is a function of the index of the sample and the displacement.
template <class Displacement, class Force>
log::Log logOf(const std::string& name, int samples, std::int64_t interval, const Displacement& displacement,
               const Force& force) {
  log::Log log = logOf(name, samples, interval, displacement);
  for (int i = 0; i < samples; ++i) {
    log.force.push_back(force(i, log.displacement[static_cast<std::size_t>(i)]));
  }
  return log;
}

/// Returns a log with a sampling rate [Hz] and a duration [s]. Its displacement [m] is a function of time [s].
template <class Displacement>
log::Log recorded(double rate, double duration, const Displacement& displacement) {
  return logOf("log", static_cast<int>(std::lround(duration * rate)), std::llround(1e9 / rate),
               [&](int i) { return displacement(i / rate); });
}

/// Returns such a log with a force [N] that is a function of time and displacement.
template <class Displacement, class Force>
log::Log recorded(double rate, double duration, const Displacement& displacement, const Force& force) {
  return logOf(
      "log", static_cast<int>(std::lround(duration * rate)), std::llround(1e9 / rate),
      [&](int i) { return displacement(i / rate); }, [&](int i, double z) { return force(i / rate, z); });
}

}  // namespace rubber_suspension
