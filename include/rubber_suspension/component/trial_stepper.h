// A component in a simulation whose integrator makes trial steps: explicit stages, rejected steps, iterations.
#pragma once

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::component {

/// Stores the state at the last step that the integrator accepted. Every trial starts from this state and does not
/// change it. Call initialise(), then any number of attempt() and tangent(), then accept(), and so on.
///
/// Between the accepted step and a trial the displacement is linear. The error of the force is therefore of second
/// order in the step length for any integrator, and the error estimate of the integrator does not include it. Limit the
/// step to about a twentieth of relaxation times and periods. A dashpot uses the mean speed since the accepted step,
/// which has an error of first order, so model viscous dampers outside of the component.
class TrialStepper {
 public:
  /// The component has to outlive this object.
  explicit TrialStepper(const Component& component);

  /// Starts with a new test piece, at rest at a displacement [m] at a time [s].
  element::ComponentForce initialise(double time, double displacement);

  /// Returns the force of a trial at a time [s] and displacement [m]. At the time of the accepted step, returns the
  /// accepted force. Throws std::invalid_argument for earlier times. Allocates nothing.
  element::ComponentForce attempt(double time, double displacement);

  /// Returns the derivatives of attempt(), for an implicit integrator: dF/dz = stiffness + damping/dt, where dt is the
  /// time since the accepted step. Throws std::invalid_argument unless `time` is later than the accepted step.
  Tangent tangent(double time, double displacement);

  /// Accepts a step of the integrator to a time [s] and displacement [m]. Returns the force. Throws like attempt().
  element::ComponentForce accept(double time, double displacement);

  double time() const { return time_; }                            ///< time of the accepted step [s]
  const element::ComponentForce& force() const { return force_; }  ///< force at the accepted step [N]

 private:
  double since(double time) const;

  const Component& component_;
  ComponentState accepted_;
  ComponentState trial_;
  double time_ = 0.0;
  element::ComponentForce force_;
};

}  // namespace rubber_suspension::component
