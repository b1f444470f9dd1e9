// A component in a simulation with trial steps: explicit stages, rejected steps, iterations.
#pragma once

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::component {

/// Stores the state at the last step that the integrator has accepted; every trial starts there and does not change it.
/// The order of calls is initialise(), then any number of attempt() and tangent(), then accept(), and so on.
///
/// From the accepted step to a trial the displacement is linear. The force is then of second order in the
/// length of accepted steps, whatever the order of the integrator, and an integrator's own estimate of its error does
/// not see that: limit its step (relaxation times and periods over about 20). A dashpot answers to the mean speed since
/// the accepted step, which is of first order; give a viscous damper to the simulation instead where there is one.
class TrialStepper {
 public:
  /// The component must outlive this object.
  explicit TrialStepper(const Component& component);

  /// A new test piece, at rest at a displacement [m] at a time [s].
  element::ComponentForce initialise(double time, double displacement);

  /// The force at a time [s] and displacement [m], tried out. At the accepted time itself it is the accepted force.
  /// Throws std::invalid_argument for a time before the accepted one. Allocates nothing.
  element::ComponentForce attempt(double time, double displacement);

  /// Derivatives of attempt() about a time later than the accepted one: for an implicit integrator, dF/dz is
  /// stiffness + damping/dt with dt the time since the accepted step. Throws as attempt() does, also at that time.
  Tangent tangent(double time, double displacement);

  /// The integrator has accepted a step that ends here. Returns the force there. Throws as attempt() does.
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
