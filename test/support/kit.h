// Elements, components and logs that tests are made of.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension {

inline element::ElementDescription spring(double stiffness /* [N/m] */) {
  return {"spring", {{"stiffness", {stiffness}}}};
}

inline element::ElementDescription dashpot(double damping /* [N s/m] */) {
  return {"dashpot", {{"damping", {damping}}}};
}

inline element::ElementDescription maxwell(double stiffness /* [N/m] */, double break_frequency /* [Hz] */) {
  return {"maxwell", {{"stiffness", {stiffness}}, {"break_frequency", {break_frequency}}}};
}

/// Forces [N], displacements [m].
inline element::ElementDescription friction(double maximum_force, double displacement) {
  return {"friction", {{"maximum_force", {maximum_force}}, {"displacement", {displacement}}}};
}

inline element::ElementDescription friction(double maximum_force, double displacement, double dead_band) {
  element::ElementDescription element = friction(maximum_force, displacement);
  element.values["dead_band"] = {dead_band};
  return element;
}

/// A component with a state, for tests of its total force [N].
struct WithState : component::Component {
  using component::Component::Component;
  component::ComponentState state = makeState();

  double step(double dt, double displacement) { return Component::step(state, dt, displacement).total; }
  double initialise(double displacement) { return Component::initialise(state, displacement).total; }
  double relax(double displacement) { return Component::relax(state, displacement).total; }
};

/// The only component of a component file. Throws ComponentFileError.
inline io::ComponentDescription componentOf(const std::string& text, const std::string& file = "test") {
  return io::parseComponentFile(text, file).at(0);
}

/// Adds white noise of this standard deviation.
inline void addNoise(std::vector<double>& values, double deviation, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, deviation);
  for (double& value : values) {
    value += normal(generator);
  }
}

/// A log at an interval [ns], whose displacement [m] follows from the number of the sample.
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

/// The same with a force [N], which follows from the number of the sample and the displacement.
template <class Displacement, class Force>
log::Log logOf(const std::string& name, int samples, std::int64_t interval, const Displacement& displacement,
               const Force& force) {
  log::Log log = logOf(name, samples, interval, displacement);
  for (int i = 0; i < samples; ++i) {
    log.force.push_back(force(i, log.displacement[static_cast<std::size_t>(i)]));
  }
  return log;
}

}  // namespace rubber_suspension
