// General solvers of ordinary differential equations on the library's work: five Maxwell elements under the
// displacement of a log, linear between samples.
#pragma once

#include <vector>

namespace rubber_suspension {

/// What a solver gets.
struct PeerWork {
  std::vector<double> stiffness;     ///< k of the Maxwell elements [N/m]
  std::vector<double> rate;          ///< 1/tau [1/s]
  double dt = 0.0;                   ///< [s]
  std::vector<double> displacement;  ///< at each sample [m]

  /// Velocity [m/s] from sample i - 1 to sample i.
  double velocity(std::size_t i) const { return (displacement[i] - displacement[i - 1]) / dt; }
};

/// dF/dt = k v - F/tau of each element.
inline void maxwellRates(const PeerWork& work, double velocity, const double* force, double* rate_of_force) {
  for (std::size_t k = 0; k < work.stiffness.size(); ++k) {
    rate_of_force[k] = work.stiffness[k] * velocity - work.rate[k] * force[k];
  }
}

constexpr double kRelativeTolerance = 1e-6;
constexpr double kAbsoluteTolerance = 1e-2;  // [N]; the forces are some kN

// Each gives the sum of the Maxwell forces [N] at each sample.

/// Boost.odeint, the classical method of Runge and Kutta with so many steps between two samples.
void odeintRungeKutta4(const PeerWork& work, int substeps, std::vector<double>& force);

/// Boost.odeint, Dormand and Prince, with control of the step.
void odeintDormandPrince(const PeerWork& work, std::vector<double>& force);

/// The GNU Scientific Library, Runge-Kutta-Fehlberg 4(5) with control of the step.
void gslFehlberg(const PeerWork& work, std::vector<double>& force);

/// SUNDIALS CVODE, backward differentiation with a dense Jacobian.
void cvodeBackwardDifferentiation(const PeerWork& work, std::vector<double>& force);

}  // namespace rubber_suspension
