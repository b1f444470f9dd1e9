// The plain loop. It repeats the laws of src/element on purpose: the error column compares the two.
#include "benchmark/bare_loop.h"

#include <algorithm>
#include <map>

#include "element/refuse.h"

namespace rubber_suspension::benchmark {
namespace {

using Loop = void (*)(const BareParameters& parameters, const std::vector<double>& step,
                      const std::vector<double>& displacement, std::vector<double>& force);

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

// Of one step and of several, by the number of Maxwell elements.
const std::map<std::size_t, std::array<Loop, 2>> kLoops = {{1, {run<1, false>, run<1, true>}},
                                                           {5, {run<5, false>, run<5, true>}},
                                                           {10, {run<10, false>, run<10, true>}},
                                                           {20, {run<20, false>, run<20, true>}}};

}  // namespace

BareParameters BareParameters::scaled(double by_stiffness, double by_force) const {
  BareParameters result = *this;
  result.spring *= by_stiffness;
  result.maximum_force *= by_force;
  result.friction_displacement *= by_force / by_stiffness;
  std::for_each(result.stiffness.begin(), result.stiffness.end(), [=](double& each) { each *= by_stiffness; });
  return result;
}

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
  const auto loop = kLoops.find(parameters.stiffness.size());
  element::refuseIf(loop == kLoops.end(), "the plain loop is there for 1, 5, 10 and 20 Maxwell elements");
  loop->second[step.size() == 1 ? 0 : 1](parameters, step, displacement, force);
}

}  // namespace rubber_suspension::benchmark
