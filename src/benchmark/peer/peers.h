// General solvers of ordinary differential equations on the library's work: five Maxwell elements under the
// displacement of a log, linear between samples.
#pragma once

#include <vector>

namespace rubber_suspension::benchmark {

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

/// The same with the displacements x of the dashpots as states, dx/dt = (z - x)/tau: the sum of forces k (z - x) [N].
inline double forceOfDashpots(const PeerWork& work, double displacement, const double* dashpot) {
  double sum = 0.0;
  for (std::size_t k = 0; k < work.stiffness.size(); ++k) {
    sum += work.stiffness[k] * (displacement - dashpot[k]);
  }
  return sum;
}

constexpr double kRelativeTolerance = 1e-6;
constexpr double kAbsoluteTolerance = 1e-2;  // [N]; the forces are some kN

// Each gives the sum of the Maxwell forces [N] at each sample.

/// Boost.odeint, the classical method of Runge and Kutta with that many steps between two samples.
void odeintRungeKutta4(const PeerWork& work, int substeps, std::vector<double>& force);

/// Boost.odeint, Dormand and Prince, with control of the step.
void odeintDormandPrince(const PeerWork& work, std::vector<double>& force);

/// The GNU Scientific Library, Runge-Kutta-Fehlberg 4(5) with control of the step.
void gslFehlberg(const PeerWork& work, std::vector<double>& force);

/// SUNDIALS CVODE, backward differentiation with a dense Jacobian.
void cvodeBackwardDifferentiation(const PeerWork& work, std::vector<double>& force);

/// Simbody, Runge-Kutta-Merson with control of the step; the dashpots are auxiliary states of a force.
void simbodyMerson(const PeerWork& work, std::vector<double>& force);

/// MuJoCo, the classical method of Runge and Kutta with that many steps between two samples; the dashpots are
/// activations of actuators.
void mujocoRungeKutta4(const PeerWork& work, int substeps, std::vector<double>& force);

}  // namespace rubber_suspension::benchmark
