// The baseline: spring, Maxwell elements and Berg friction as a plain scalar loop, written by hand for this alone.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::benchmark {

/// Numbers of a component: spring, Maxwell elements of one total stiffness spread over the log of frequency, friction.
struct BareParameters {
  double spring = 3.0e6;                  ///< [N/m]
  std::vector<double> stiffness;          ///< of the Maxwell elements [N/m]
  std::vector<double> break_frequency;    ///< [Hz]
  double maximum_force = 5000.0;          ///< F_max [N]
  double friction_displacement = 2.2e-3;  ///< z2 [m]
};

/// That many Maxwell elements of 1.9 MN/m together, break frequencies from 0.03 Hz to the highest [Hz].
BareParameters bareParameters(int maxwell_elements, double highest = 25.0);

/// The same numbers as entries of a component file.
std::vector<element::ElementDescription> elementsOf(const BareParameters& parameters);

/// Memory of friction between steps: displacement and force of the last sample, reference point, direction of motion.
struct BareFriction {
  double last_displacement = 0.0;
  double reference_displacement = 0.0;
  double last_force = 0.0;
  double reference_force = 0.0;
  double direction = 0.0;

  /// Advance to a displacement [m], Berg's two branches as printed; returns the force [N].
  inline double advance(double displacement, double maximum_force, double half_displacement) {
    if ((displacement - last_displacement) * direction < 0.0) {
      reference_displacement = last_displacement;
      reference_force = last_force;
      direction = -direction;
    } else if (direction == 0.0 && displacement != last_displacement) {
      direction = displacement > last_displacement ? 1.0 : -1.0;
    }
    last_displacement = displacement;
    const double way = displacement - reference_displacement;
    const double mu = reference_force / maximum_force;
    if (way > 0.0) {
      last_force = reference_force + way * (maximum_force - reference_force) / (half_displacement * (1.0 - mu) + way);
    } else if (way < 0.0) {
      last_force = reference_force + way * (maximum_force + reference_force) / (half_displacement * (1.0 + mu) - way);
    } else {
      last_force = reference_force;
    }
    return last_force;
  }
};

/// Force [N] at every sample, at rest at the first one. One step [s] holds throughout; of several, step[i] ends at
/// sample i.
void bareLoop(const BareParameters& parameters, const std::vector<double>& step,
              const std::vector<double>& displacement, std::vector<double>& force);

/// Steps of a Maxwell element: F' = decay F + gain (z' - z).
template <int n>
struct BareSteps {
  std::array<double, n> decay;
  std::array<double, n> gain;

  /// For a step [s], from stiffness [N/m] and relaxation time [s] of each.
  void set(const std::array<double, n>& stiffness, const std::array<double, n>& relaxation_time, double dt) {
    for (int i = 0; i < n; ++i) {
      const double ratio = dt / relaxation_time[i];
      const double released = -std::expm1(-ratio);
      decay[i] = 1.0 - released;
      gain[i] = stiffness[i] * released / ratio;
    }
  }
};

/// A component with five Maxwell elements among many: a tick brings it to a displacement [m] and returns its force [N].
class BareMember {
 public:
  BareMember(const BareParameters& parameters, double dt);

  double tick(double displacement, double increment) {
    double sum = spring_ * displacement;
    for (std::size_t i = 0; i < force_.size(); ++i) {
      force_[i] = steps_.decay[i] * force_[i] + steps_.gain[i] * increment;
      sum += force_[i];
    }
    return sum + friction_.advance(displacement, maximum_force_, friction_displacement_);
  }

 private:
  double spring_;
  double maximum_force_;
  double friction_displacement_;
  BareSteps<5> steps_{};
  std::array<double, 5> force_{};
  BareFriction friction_;
};

}  // namespace rubber_suspension::benchmark
