// Three ways to step the vehicle: variable steps with trials, an implicit method, and a loop with held forces.
#pragma once

#include <cstdint>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "vehicle/force_exchange.h"
#include "vehicle/history.h"
#include "vehicle/track.h"

namespace rubber_suspension::vehicle {

/// The settings of every run.
struct Scene {
  VehicleParameters parameters;
  Track track;
  double duration = 0.0;        ///< [s]
  std::int64_t step = 1000000;  ///< between records, and of the fixed steps [ns]
  Coordinates kick = {};        ///< speeds at the start [m/s, rad/s, m/s]

  std::int64_t steps() const;
  double time(std::int64_t n) const { return 1e-9 * static_cast<double>(n * step); }  ///< [s]
};

/// How an explicit integrator chooses its steps.
struct VariableStep {
  double accuracy = 1e-8;   ///< Simbody's measure of the error of a step
  double longest = 0.5e-3;  ///< [s]; see TrialStepper for why there is such a bound
};

/// The counts of an integrator.
struct StepCount {
  int accepted = 0;
  int taken_back = 0;  ///< steps tried and rejected
};

/// Runge-Kutta-Merson with variable steps: forces of trial steps, the components' memory advances with accepted ones.
/// No delay: the reference for the others. Throws std::runtime_error where the integrator gives up.
History runVariableStep(const Scene& scene, const std::vector<component::Component>& components,
                        const VariableStep& options, StepCount* count = nullptr);

/// Newmark's method (average acceleration) with Newton iterations on the residual of the multibody system, with the
/// tangents of the components. Throws std::runtime_error where an iteration does not converge.
History runImplicit(const Scene& scene, const std::vector<component::Component>& components, int* iterations = nullptr);

/// A loop with a partner that answers displacements with forces at fixed steps. The forces of step n - delay act,
/// constant, from step n to step n + 1: they are late by (delay + 1/2) steps in the mean. With delay 0 each step waits
/// for its answer; with 1 the partner computes while the vehicle does. The history holds the forces that act.
/// `stop_at` ends the run early where a speed exceeds it [m/s, rad/s].
History runExchange(const Scene& scene, ForceExchange& exchange, int delay, double stop_at = 1e9);

/// The same with components of six directions, from rest. Throw std::runtime_error as above, and where a rotation goes
/// beyond the end of a component's measure.
BushedHistory runVariableStep(const Scene& scene, BushedKind kind, const PerBush<component::SixDirections>& components,
                              const VariableStep& options);
BushedHistory runExchange(const Scene& scene, BushedKind kind, WrenchExchange& exchange, int delay);

/// The mean delay of forces in such a loop [s].
inline double loopDelay(double step, int delay) { return (delay + 0.5) * step; }

}  // namespace rubber_suspension::vehicle
