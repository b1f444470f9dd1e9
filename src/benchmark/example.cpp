// The component and the motion of a benchmark.
#include "benchmark/example.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/replay.h"

namespace rubber_suspension::benchmark {

std::vector<double> benchmarkDisplacement(std::size_t samples) {
  std::vector<double> displacement(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = kStep * static_cast<double>(i);
    displacement[i] = 1.0e-3 * std::sin(2.0 * element::kPi * 1.3 * t) +
                      0.8e-3 * std::sin(2.0 * element::kPi * 4.0 * t) +
                      0.2e-3 * std::sin(2.0 * element::kPi * 17.0 * t);
  }
  return displacement;
}

std::vector<std::int64_t> stampsOf(Stamps kind, std::size_t samples) {
  std::mt19937_64 random(1);
  std::vector<std::int64_t> stamps(samples);
  for (std::size_t i = 1; i < samples; ++i) {
    // The jitter is alternately odd and even, so that no step has the same length as the step before it.
    const auto jitter = static_cast<std::int64_t>(random() % 300000) * 2 + static_cast<std::int64_t>(i % 2);
    stamps[i] = stamps[i - 1] + (kind == Stamps::even ? 1000000 : 700000 + jitter);
  }
  return stamps;
}

ExampleParameters::ExampleParameters(int maxwell_elements) {
  constexpr double kTotal = 1.9e6;   // [N/m]
  constexpr double kLowest = 0.03;   // [Hz]
  constexpr double kHighest = 25.0;  // [Hz]
  for (int i = 0; i < maxwell_elements; ++i) {
    stiffness.push_back(kTotal / maxwell_elements);
    break_frequency.push_back(kLowest * std::pow(kHighest / kLowest, (i + 0.5) / maxwell_elements));
  }
}

ExampleParameters ExampleParameters::scaled(double by_stiffness, double by_force) const {
  ExampleParameters result = *this;
  result.spring *= by_stiffness;
  result.maximum_force *= by_force;
  result.friction_displacement *= by_force / by_stiffness;
  std::for_each(result.stiffness.begin(), result.stiffness.end(), [=](double& each) { each *= by_stiffness; });
  return result;
}

std::vector<element::ElementDescription> ExampleParameters::elements() const {
  std::vector<element::ElementDescription> all{{"spring", {{"stiffness", {spring}}}}};
  for (std::size_t i = 0; i < stiffness.size(); ++i) {
    all.push_back({"maxwell", {{"stiffness", {stiffness[i]}}, {"break_frequency", {break_frequency[i]}}}});
  }
  all.push_back({"friction", {{"maximum_force", {maximum_force}}, {"displacement", {friction_displacement}}}});
  return all;
}

ExampleRun::ExampleRun(const ExampleParameters& parameters, Stamps kind, std::size_t samples)
    : component(parameters.elements()), steps(samples), force(samples) {
  log.name = "benchmark";
  log.stamp = stampsOf(kind, samples);
  log.displacement = benchmarkDisplacement(samples);
  std::adjacent_difference(log.stamp.begin(), log.stamp.end(), steps.begin(),
                           [](auto end, auto begin) { return static_cast<double>(end - begin) / 1e9; });
}

void ExampleRun::step() {
  component::ComponentState state = component.makeState();
  force[0] = component.initialise(state, log.displacement[0]).total;
  for (std::size_t i = 1; i < force.size(); ++i) {
    force[i] = component.step(state, steps[i], log.displacement[i]).total;
  }
}

void ExampleRun::push() {
  component::SampleStream stream(component);
  for (std::size_t i = 0; i < force.size(); ++i) {
    force[i] = stream.push(log.stamp[i], log.displacement[i]).force.total;
  }
}

void ExampleRun::simulate() {
  component::ComponentState state = component.makeState();
  const std::vector<double>& z = log.displacement;
  force[0] = component.initialise(state, z[0]).total;
  component.simulate(state, kStep, z.data() + 1, z.size() - 1, force.data() + 1);
}

void ExampleRun::simulateWholeLog() { force = gap::simulateLog(component, log); }

component::SixDirectionsLaws exampleBush(component::Coupling coupling) {
  constexpr double kLength = 0.02;  // [m/rad]; a rotation of 0.1 rad corresponds to 2 mm
  component::SixDirectionsLaws laws;
  laws.translation = laws.rotation = coupling;
  for (std::size_t k = 0; k < component::kDirections; ++k) {
    const ExampleParameters parameters;
    laws.elements[k] = (k < 3 ? parameters : parameters.scaled(kLength * kLength, kLength)).elements();
    for (element::ElementDescription& element : laws.elements[k]) {
      const bool together = coupling != component::Coupling::rectangular;
      element.type = together && element.type == "friction" ? "iwan" : element.type;
    }
  }
  return laws;
}

}  // namespace rubber_suspension::benchmark
