// The baseline for the library: spring, Maxwell elements and Berg friction as a handwritten scalar loop.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "benchmark/example.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::benchmark {

/// State of friction between steps: the last sample, the reference point and the direction of motion.
struct BareFriction {
  double last_displacement = 0.0;
  double reference_displacement = 0.0;
  double last_force = 0.0;
  double reference_force = 0.0;
  double direction = 0.0;

  /// Advances to a displacement [m] along one of Berg's two branches, and returns the force [N].
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

/// Computes the force [N] at every sample, from rest at the first sample. A single `step` [s] applies to all samples.
/// If there are several, step[i] ends at sample i.
void bareLoop(const ExampleParameters& parameters, const std::vector<double>& step,
              const std::vector<double>& displacement, std::vector<double>& force);

/// Stiffnesses and relaxation times of n Maxwell elements. The compiler knows n, so the loop is as fast as possible.
template <int n>
struct BareMaxwells {
  std::array<double, n> stiffness;        ///< [N/m]
  std::array<double, n> relaxation_time;  ///< [s]

  explicit BareMaxwells(const ExampleParameters& parameters) {
    for (int i = 0; i < n; ++i) {
      stiffness[i] = parameters.stiffness[i];
      relaxation_time[i] = 1.0 / (2.0 * element::kPi * parameters.break_frequency[i]);
    }
  }
};

/// A component with its state. tick() moves it to a displacement [m] and returns its force [N].
template <int n>
class BareComponent {
 public:
  /// Starts at rest at a displacement [m].
  explicit BareComponent(const ExampleParameters& parameters, double displacement = 0.0)
      : spring_(parameters.spring),
        maximum_force_(parameters.maximum_force),
        friction_displacement_(parameters.friction_displacement),
        friction_{displacement, displacement} {}

  /// Sets the time step dt [s]. An element then steps by F' = decay F + gain (z' - z).
  void setStep(const BareMaxwells<n>& maxwells, double dt) {
    for (int i = 0; i < n; ++i) {
      const double ratio = dt / maxwells.relaxation_time[i];
      const double released = -std::expm1(-ratio);
      decay_[i] = 1.0 - released;
      gain_[i] = maxwells.stiffness[i] * released / ratio;
    }
  }

  double tick(double displacement, double increment) {
    double sum = spring_ * displacement;
    for (int i = 0; i < n; ++i) {
      force_[i] = decay_[i] * force_[i] + gain_[i] * increment;
      sum += force_[i];
    }
    return sum + friction_.advance(displacement, maximum_force_, friction_displacement_);
  }

 private:
  double spring_;
  double maximum_force_;
  double friction_displacement_;
  std::array<double, n> decay_{};
  std::array<double, n> gain_{};
  std::array<double, n> force_{};
  BareFriction friction_;
};

}  // namespace rubber_suspension::benchmark
