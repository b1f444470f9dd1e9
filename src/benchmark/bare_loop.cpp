// The plain loop. It repeats the laws of src/element on purpose: the error column compares the two.
#include "benchmark/bare_loop.h"

#include <cmath>
#include <stdexcept>

namespace rubber_suspension::benchmark {
namespace {

template <int n, bool steps_differ>
void run(const BareParameters& parameters, const std::vector<double>& step, const std::vector<double>& displacement,
         std::vector<double>& force) {
  const BareMaxwells<n> maxwells(parameters);
  BareComponent<n> component(parameters, displacement[0]);
  component.setStep(maxwells, step.front());
  force[0] = parameters.spring * displacement[0];
  for (std::size_t i = 1; i < displacement.size(); ++i) {
    if (steps_differ) {
      component.setStep(maxwells, step[i]);
    }
    force[i] = component.tick(displacement[i], displacement[i] - displacement[i - 1]);
  }
}

template <int n>
void runFor(const BareParameters& parameters, const std::vector<double>& step, const std::vector<double>& displacement,
            std::vector<double>& force) {
  (step.size() == 1 ? run<n, false> : run<n, true>)(parameters, step, displacement, force);
}

}  // namespace

BareParameters bareParameters(int maxwell_elements, double highest) {
  constexpr double kTotal = 1.9e6;  // [N/m]
  constexpr double kLowest = 0.03;  // [Hz]
  BareParameters parameters;
  for (int i = 0; i < maxwell_elements; ++i) {
    parameters.stiffness.push_back(kTotal / maxwell_elements);
    parameters.break_frequency.push_back(kLowest * std::pow(highest / kLowest, (i + 0.5) / maxwell_elements));
  }
  return parameters;
}

std::vector<element::ElementDescription> elementsOf(const BareParameters& parameters) {
  std::vector<element::ElementDescription> elements{{"spring", {{"stiffness", {parameters.spring}}}}};
  for (std::size_t i = 0; i < parameters.stiffness.size(); ++i) {
    elements.push_back(
        {"maxwell", {{"stiffness", {parameters.stiffness[i]}}, {"break_frequency", {parameters.break_frequency[i]}}}});
  }
  elements.push_back(
      {"friction",
       {{"maximum_force", {parameters.maximum_force}}, {"displacement", {parameters.friction_displacement}}}});
  return elements;
}

void bareLoop(const BareParameters& parameters, const std::vector<double>& step,
              const std::vector<double>& displacement, std::vector<double>& force) {
  switch (parameters.stiffness.size()) {
    case 1:
      return runFor<1>(parameters, step, displacement, force);
    case 5:
      return runFor<5>(parameters, step, displacement, force);
    case 10:
      return runFor<10>(parameters, step, displacement, force);
    case 20:
      return runFor<20>(parameters, step, displacement, force);
    default:
      throw std::invalid_argument("the plain loop is there for 1, 5, 10 and 20 Maxwell elements");
  }
}

}  // namespace rubber_suspension::benchmark
