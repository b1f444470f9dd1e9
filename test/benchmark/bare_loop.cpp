// The handwritten loop. It repeats the laws of src/element, so that the errors in the table are an independent check.
#include "benchmark/bare_loop.h"

#include <map>

#include "element/refuse.h"

namespace rubber_suspension::benchmark {
namespace {

using Loop = void (*)(const ExampleParameters& parameters, const std::vector<double>& step,
                      const std::vector<double>& displacement, std::vector<double>& force);

template <int n, bool steps_differ>
void run(const ExampleParameters& parameters, const std::vector<double>& step, const std::vector<double>& displacement,
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

// The loops for a constant time step and for varying steps, by number of Maxwell elements.
const std::map<std::size_t, std::array<Loop, 2>> kLoops = {{1, {run<1, false>, run<1, true>}},
                                                           {5, {run<5, false>, run<5, true>}},
                                                           {10, {run<10, false>, run<10, true>}},
                                                           {20, {run<20, false>, run<20, true>}}};

}  // namespace

void bareLoop(const ExampleParameters& parameters, const std::vector<double>& step,
              const std::vector<double>& displacement, std::vector<double>& force) {
  const auto loop = kLoops.find(parameters.stiffness.size());
  element::refuseIf(loop == kLoops.end(), "the plain loop is there for 1, 5, 10 and 20 Maxwell elements");
  loop->second[step.size() == 1 ? 0 : 1](parameters, step, displacement, force);
}

}  // namespace rubber_suspension::benchmark
