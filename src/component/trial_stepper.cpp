// A component in a simulation whose integrator makes trial steps.
#include "rubber_suspension/component/trial_stepper.h"

#include <fmt/format.h>

#include <stdexcept>

namespace rubber_suspension::component {

TrialStepper::TrialStepper(const Component& component)
    : component_(component), accepted_(component.makeState()), trial_(component.makeState()) {
  force_ = component_.initialise(accepted_, 0.0);
}

double TrialStepper::since(double time) const {
  if (!(time >= time_)) {
    throw std::invalid_argument(fmt::format(
        "time {:.9g} s is before the time of the accepted step, {:.9g} s; accepted: a later time", time, time_));
  }
  return time - time_;
}

element::ComponentForce TrialStepper::initialise(double time, double displacement) {
  time_ = time;
  force_ = component_.initialise(accepted_, displacement);
  return force_;
}

element::ComponentForce TrialStepper::attempt(double time, double displacement) {
  const double dt = since(time);
  if (dt == 0.0) {
    return force_;
  }
  trial_.copyFrom(accepted_);
  return component_.step(trial_, dt, displacement);
}

Tangent TrialStepper::tangent(double time, double displacement) {
  const double dt = since(time);
  if (dt == 0.0) {
    throw std::invalid_argument(
        fmt::format("no tangent exists at the time of the accepted step, {:.9g} s; accepted: a later time", time));
  }
  return component_.tangent(accepted_, dt, displacement, trial_);
}

element::ComponentForce TrialStepper::accept(double time, double displacement) {
  const double dt = since(time);
  if (dt > 0.0) {
    force_ = component_.step(accepted_, dt, displacement);
    time_ = time;
  }
  return force_;
}

}  // namespace rubber_suspension::component
