// The baseline: spring, Maxwell elements and Berg friction as a plain scalar loop, written by hand for this alone.
#pragma once

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
  double last_force = 0.0;
  double reference_displacement = 0.0;
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

/// Force [N] at every sample, at rest at the first one; dt [s] is the same throughout.
void bareLoop(const BareParameters& parameters, double dt, const std::vector<double>& displacement,
              std::vector<double>& force);

/// The same with a step of its own before each sample but the first: step[i] [s] ends at sample i.
void bareLoop(const BareParameters& parameters, const std::vector<double>& step,
              const std::vector<double>& displacement, std::vector<double>& force);

/// Many components with five Maxwell elements each, one after the other at every tick.
class BareMany {
 public:
  BareMany(const std::vector<BareParameters>& parameters, double dt);

  /// Bring all components to a displacement [m]; the forces [N] go to `force`, one per component.
  void tick(double displacement, std::vector<double>& force);

 private:
  static constexpr int kElements = 5;
  struct Member {
    double spring;
    double maximum_force;
    double friction_displacement;
    double decay[kElements];
    double gain[kElements];
    double maxwell_force[kElements];
    BareFriction friction;
  };
  std::vector<Member> members_;
  double last_displacement_ = 0.0;
};

}  // namespace rubber_suspension::benchmark
