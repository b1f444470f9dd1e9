// The plain loop. It repeats the laws of src/element on purpose: the error column compares the two.
#include "benchmark/bare_loop.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::benchmark {
namespace {

// Coefficients of the exact step of n Maxwell elements.
template <int n>
struct Coefficients {
  std::array<double, n> decay;
  std::array<double, n> gain;

  void set(const std::array<double, n>& stiffness, const std::array<double, n>& relaxation_time, double dt) {
    for (int i = 0; i < n; ++i) {
      const double ratio = dt / relaxation_time[i];
      const double released = -std::expm1(-ratio);
      decay[i] = 1.0 - released;
      gain[i] = stiffness[i] * released / ratio;
    }
  }
};

// n is known to the compiler, which makes the loop as fast as a plain one gets. `dt` is called for the step to sample i
// where steps differ.
template <int n, bool steps_differ, class StepLength>
void run(const BareParameters& parameters, StepLength dt, const std::vector<double>& displacement,
         std::vector<double>& force) {
  std::array<double, n> stiffness{};
  std::array<double, n> relaxation_time{};
  for (int i = 0; i < n; ++i) {
    stiffness[i] = parameters.stiffness[i];
    relaxation_time[i] = 1.0 / (2.0 * element::kPi * parameters.break_frequency[i]);
  }
  Coefficients<n> coefficients{};
  coefficients.set(stiffness, relaxation_time, dt(1));
  std::array<double, n> maxwell{};
  BareFriction friction;
  friction.last_displacement = friction.reference_displacement = displacement[0];
  force[0] = parameters.spring * displacement[0];
  double last = displacement[0];
  for (std::size_t sample = 1; sample < displacement.size(); ++sample) {
    if (steps_differ) {
      coefficients.set(stiffness, relaxation_time, dt(sample));
    }
    const double z = displacement[sample];
    const double increment = z - last;
    last = z;
    double sum = parameters.spring * z;
    for (int i = 0; i < n; ++i) {
      maxwell[i] = coefficients.decay[i] * maxwell[i] + coefficients.gain[i] * increment;
      sum += maxwell[i];
    }
    force[sample] = sum + friction.advance(z, parameters.maximum_force, parameters.friction_displacement);
  }
}

template <bool steps_differ, class StepLength>
void runForCount(const BareParameters& parameters, StepLength dt, const std::vector<double>& displacement,
                 std::vector<double>& force) {
  switch (parameters.stiffness.size()) {
    case 1:
      return run<1, steps_differ>(parameters, dt, displacement, force);
    case 5:
      return run<5, steps_differ>(parameters, dt, displacement, force);
    case 10:
      return run<10, steps_differ>(parameters, dt, displacement, force);
    case 20:
      return run<20, steps_differ>(parameters, dt, displacement, force);
    default:
      throw std::invalid_argument("the plain loop is there for 1, 5, 10 and 20 Maxwell elements");
  }
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

void bareLoop(const BareParameters& parameters, double dt, const std::vector<double>& displacement,
              std::vector<double>& force) {
  runForCount<false>(
      parameters, [dt](std::size_t /*sample*/) { return dt; }, displacement, force);
}

void bareLoop(const BareParameters& parameters, const std::vector<double>& step,
              const std::vector<double>& displacement, std::vector<double>& force) {
  runForCount<true>(
      parameters, [&step](std::size_t sample) { return step[sample]; }, displacement, force);
}

BareMany::BareMany(const std::vector<BareParameters>& parameters, double dt) {
  for (const BareParameters& given : parameters) {
    if (given.stiffness.size() != kElements) {
      throw std::invalid_argument("the plain loop over components is there for 5 Maxwell elements");
    }
    Member member{given.spring, given.maximum_force, given.friction_displacement, {}, {}, {}, {}};
    for (int i = 0; i < kElements; ++i) {
      const double ratio = 2.0 * element::kPi * given.break_frequency[i] * dt;
      const double released = -std::expm1(-ratio);
      member.decay[i] = 1.0 - released;
      member.gain[i] = given.stiffness[i] * released / ratio;
    }
    members_.push_back(member);
  }
}

void BareMany::tick(double displacement, std::vector<double>& force) {
  const double increment = displacement - last_displacement_;
  last_displacement_ = displacement;
  double* result = force.data();
  for (Member& member : members_) {
    double sum = member.spring * displacement;
    for (int i = 0; i < kElements; ++i) {
      member.maxwell_force[i] = member.decay[i] * member.maxwell_force[i] + member.gain[i] * increment;
      sum += member.maxwell_force[i];
    }
    *result++ = sum + member.friction.advance(displacement, member.maximum_force, member.friction_displacement);
  }
}

}  // namespace rubber_suspension::benchmark
