// A component in a simulation with trial steps: explicit stages, rejected steps, iterations.
#pragma once

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::component {

/// Stores the state at the last step that the integrator has accepted; every trial starts there and does not change it.
/// The order of calls is initialise(), then any number of attempt() and tangent(), then accept(), and so on.
///
/// Between the accepted step and a trial the displacement is linear. The error of the force is therefore of second
/// order in the length of accepted steps, whatever the order of the integrator, whose own estimate does not include it:
/// limit the step to about a twentieth of relaxation times and periods. A dashpot has the mean speed since the accepted
/// step, with an error of first order; model a viscous damper in the simulation instead.
class TrialStepper {
 public:
  /// The component must outlive this object.
  explicit TrialStepper(const Component& component);

  /// Starts with a new test piece, at rest at a displacement [m] at a time [s].
  element::ComponentForce initialise(double time, double displacement);

  /// Returns the force of a trial at a time [s] and displacement [m]; at the accepted time itself, the accepted force.
  /// Throws std::invalid_argument for a time before the accepted one. Allocates nothing.
  element::ComponentForce attempt(double time, double displacement);

  /// Returns the derivatives of attempt() after the accepted time: for an implicit integrator, dF/dz = stiffness +
  /// damping/dt, dt being the time since the accepted step. Throws as attempt() does, also at the accepted time.
  Tangent tangent(double time, double displacement);

  /// Accepts a step of the integrator that ends here. Returns the force there. Throws as attempt() does.
  element::ComponentForce accept(double time, double displacement);

  double time() const { return time_; }                            ///< of the accepted step [s]
  const element::ComponentForce& force() const { return force_; }  ///< at the accepted step [N]

 private:
  double since(double time) const;

  const Component& component_;
  ComponentState accepted_;
  ComponentState trial_;
  double time_ = 0.0;
  element::ComponentForce force_;
};

}  // namespace rubber_suspension::component
