// The plain loop. It repeats the laws of src/element on purpose: the error column compares the two.
#include "benchmark/bare_loop.h"

#include <cmath>
#include <stdexcept>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::benchmark {
namespace {

template <int n>
struct Maxwells {
  std::array<double, n> stiffness;        // [N/m]
  std::array<double, n> relaxation_time;  // [s]

  explicit Maxwells(const BareParameters& parameters) {
    for (int i = 0; i < n; ++i) {
      stiffness[i] = parameters.stiffness[i];
      relaxation_time[i] = 1.0 / (2.0 * element::kPi * parameters.break_frequency[i]);
    }
  }
};

// n is known to the compiler, which makes the loop as fast as a plain one gets.
template <int n, bool steps_differ>
void run(const BareParameters& parameters, const std::vector<double>& step, const std::vector<double>& displacement,
         std::vector<double>& force) {
  const Maxwells<n> maxwells(parameters);
  BareSteps<n> steps{};
  steps.set(maxwells.stiffness, maxwells.relaxation_time, step.front());
  std::array<double, n> maxwell{};
  BareFriction friction{displacement[0], displacement[0]};
  force[0] = parameters.spring * displacement[0];
  double last = displacement[0];
  for (std::size_t sample = 1; sample < displacement.size(); ++sample) {
    if (steps_differ) {
      steps.set(maxwells.stiffness, maxwells.relaxation_time, step[sample]);
    }
    const double z = displacement[sample];
    const double increment = z - last;
    last = z;
    double sum = parameters.spring * z;
    for (int i = 0; i < n; ++i) {
      maxwell[i] = steps.decay[i] * maxwell[i] + steps.gain[i] * increment;
      sum += maxwell[i];
    }
    force[sample] = sum + friction.advance(z, parameters.maximum_force, parameters.friction_displacement);
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

BareMember::BareMember(const BareParameters& parameters, double dt)
    : spring_(parameters.spring),
      maximum_force_(parameters.maximum_force),
      friction_displacement_(parameters.friction_displacement) {
  const Maxwells<5> maxwells(parameters);
  steps_.set(maxwells.stiffness, maxwells.relaxation_time, dt);
}

}  // namespace rubber_suspension::benchmark
