// General solvers of ordinary differential equations on the library's work: five Maxwell elements under the
// displacement of a log, linear between samples.
#pragma once

#include <array>
#include <vector>

#include "benchmark/bare_loop.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::benchmark {

/// What a solver gets.
struct PeerWork {
  std::array<double, 5> stiffness{};  ///< k of the Maxwell elements [N/m]
  std::array<double, 5> rate{};       ///< 1/tau [1/s]
  double dt;                          ///< [s]
  std::vector<double> displacement;   ///< at each sample [m]

  PeerWork(const BareParameters& parameters, double step, const std::vector<double>& motion)
      : dt(step), displacement(motion) {
    for (std::size_t k = 0; k < rate.size(); ++k) {
      stiffness[k] = parameters.stiffness.at(k);
      rate[k] = 2.0 * element::kPi * parameters.break_frequency.at(k);
    }
  }

  /// Velocity [m/s] from sample i - 1 to sample i.
  double velocity(std::size_t i) const { return (displacement[i] - displacement[i - 1]) / dt; }
};

// Each gives the sum of the Maxwell forces [N] at each sample.

/// Boost.odeint, Dormand and Prince, with control of the step.
void odeintDormandPrince(const PeerWork& work, std::vector<double>& force);

/// Simbody, Runge-Kutta-Merson with control of the step; the dashpots are auxiliary states of a force.
void simbodyMerson(const PeerWork& work, std::vector<double>& force);

}  // namespace rubber_suspension::benchmark
