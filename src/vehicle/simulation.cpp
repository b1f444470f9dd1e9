// Three ways to step the vehicle.
#include "vehicle/simulation.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "element/refuse.h"
#include "rubber_suspension/component/trial_stepper.h"
#include "vehicle/bushed_vehicle.h"
#include "vehicle/half_bogie.h"

namespace rubber_suspension::vehicle {
namespace {

using SimTK::Stage;
using SimTK::State;
using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

// Forces of trial steps from the state at the accepted one.
class TrialLaw final : public StrutLaw {
 public:
  explicit TrialLaw(const std::vector<component::Component>& components) {
    for (const component::Component& component : components) {
      steppers_.emplace_back(component);
    }
  }

  double load(std::size_t strut, double time, const double& compression) override {
    return steppers_[strut].attempt(time, compression).total;
  }

  void initialise(double time, const PerStrut& compression) {
    for (std::size_t i = 0; i < kStruts; ++i) {
      steppers_[i].initialise(time, compression[i]);
    }
  }

  PerStrut accept(double time, const PerStrut& compression) {
    PerStrut force{};
    for (std::size_t i = 0; i < kStruts; ++i) {
      force[i] = steppers_[i].accept(time, compression[i]).total;
    }
    return force;
  }

  component::Tangent tangent(std::size_t strut, double time, double compression) {
    return steppers_[strut].tangent(time, compression);
  }

 private:
  std::vector<component::TrialStepper> steppers_;
};

// The same of six directions: wrenches of trial steps from the states at the accepted one.
class BushTrials final : public WrenchLaw {
 public:
  explicit BushTrials(const PerBush<component::SixDirections>& components) : components_(components) {
    for (const component::SixDirections& component : components) {
      accepted_.push_back(component.makeState());
    }
    trial_ = accepted_;
    wrenches_.resize(components.size());
  }

  component::Wrench load(std::size_t bush, double time, const Eigen::Isometry3d& pose) override {
    if (time <= time_) {
      return wrenches_[bush];
    }
    trial_[bush].copyFrom(accepted_[bush]);
    return components_[bush].step(trial_[bush], time - time_, pose).wrench;
  }

  void initialise(double time, const PerBush<Eigen::Isometry3d>& poses) {
    time_ = time;
    for (std::size_t i = 0; i < components_.size(); ++i) {
      wrenches_[i] = components_[i].initialise(accepted_[i], poses[i]).wrench;
    }
  }

  const PerBush<component::Wrench>& accept(double time, const PerBush<Eigen::Isometry3d>& poses) {
    for (std::size_t i = 0; i < components_.size() && time > time_; ++i) {
      element::refuseIf<std::runtime_error>(!components_[i].holds(components_[i].coordinates(poses[i])),
                                            "component {} at {:.6g} s: a rotation beyond the end of its measure", i + 1,
                                            time);
      wrenches_[i] = components_[i].step(accepted_[i], time - time_, poses[i]).wrench;
    }
    time_ = time;
    return wrenches_;
  }

 private:
  const PerBush<component::SixDirections>& components_;
  PerBush<component::SixDirectionsState> accepted_;
  PerBush<component::SixDirectionsState> trial_;
  PerBush<component::Wrench> wrenches_;
  double time_ = 0.0;
};

// Loads that somebody else has set.
template <class Motion, class Loads>
class HeldLoads final : public LoadLaw<Motion, typename Loads::value_type> {
 public:
  typename Loads::value_type load(std::size_t component, double /*time*/, const Motion& /*motion*/) override {
    return held[component];
  }

  Loads held{};
};

PerStrut motionsOf(const HalfBogie& bogie, const State& state) { return bogie.compressions(state); }
PerBush<Eigen::Isometry3d> motionsOf(const BushedVehicle& vehicle, const State& state) {
  return vehicle.motions(state);
}

// Add a state and the forces that act there.
void add(History& history, const HalfBogie& bogie, const State& state, const PerStrut& force) {
  history.time.push_back(state.getTime());
  history.position.push_back({state.getQ()[0], state.getQ()[1], state.getQ()[2]});
  history.compression.push_back(bogie.compressions(state));
  history.force.push_back(force);
}

void add(BushedHistory& history, const BushedVehicle& vehicle, const State& state,
         const PerBush<component::Wrench>& wrenches) {
  history.time.push_back(state.getTime());
  history.pose.push_back(vehicle.motions(state));
  history.wrench.push_back(wrenches);
}

State startOf(const Scene& scene, const HalfBogie& bogie) {
  State state = bogie.restState();
  state.updU() = SimTK::Vector(SimTK::Vec3(scene.kick[0], scene.kick[1], scene.kick[2]));
  bogie.system().realize(state, Stage::Position);
  return state;
}

// Steps that end where they are told to, and are seen one by one.
void prepare(SimTK::Integrator& integrator, const VariableStep& options) {
  integrator.setAccuracy(options.accuracy);
  integrator.setMaximumStepSize(options.longest);
  integrator.setAllowInterpolation(false);
  integrator.setReturnEveryInternalStep(true);
}

Vector toEigen(const SimTK::Vector& vector) { return {vector[0], vector[1], vector[2]}; }

Matrix massMatrix(const HalfBogie& bogie, const State& state) {
  SimTK::Matrix mass;
  bogie.matter().calcM(state, mass);
  Matrix result;
  for (int row = 0; row < result.rows(); ++row) {
    for (int column = 0; column < result.cols(); ++column) {
      result(row, column) = mass(row, column);
    }
  }
  return result;
}

// Newmark's method. The masses do not move against their joints, so speeds are derivatives of coordinates.
class Newmark {
 public:
  Newmark(const HalfBogie& bogie, TrialLaw& law, State& state) : bogie_(bogie), law_(law), state_(state) {
    bogie_.system().realize(state_, Stage::Acceleration);
    mass_ = massMatrix(bogie_, state_);
    acceleration_ = toEigen(state_.getUDot());
  }

  // Advance to a time; returns the number of iterations.
  int step(double time) {
    const double h = time - state_.getTime();
    const Vector position = toEigen(state_.getQ());
    const Vector speed = toEigen(state_.getU());
    Vector guess = position + h * speed + 0.5 * h * h * acceleration_;
    state_.setTime(time);
    for (int iteration = 1; iteration <= kMostIterations; ++iteration) {
      const Vector acceleration = (guess - position) * (4.0 / (h * h)) - speed * (4.0 / h) - acceleration_;
      set(guess, (guess - position) * (2.0 / h) - speed);
      const Vector correction = jacobian(h).ldlt().solve(residual(acceleration));
      guess -= correction;
      if (correction.norm() < kConverged) {
        const Vector last = (guess - position) * (4.0 / (h * h)) - speed * (4.0 / h) - acceleration_;
        set(guess, (guess - position) * (2.0 / h) - speed);
        acceleration_ = last;
        return iteration;
      }
    }
    throw std::runtime_error(fmt::format("implicit step to {:.6g} s does not converge", time));
  }

 private:
  static constexpr int kMostIterations = 30;
  static constexpr double kConverged = 1e-12;  // [m, rad]; a millionth of a newton at 1 MN/m

  void set(const Vector& position, const Vector& speed) {
    for (int i = 0; i < position.size(); ++i) {
      state_.updQ()[i] = position[i];
      state_.updU()[i] = speed[i];
    }
    bogie_.system().realize(state_, Stage::Dynamics);
  }

  // Masses times accelerations minus all forces, by Simbody.
  Vector residual(const Vector& acceleration) const {
    const SimTK::Vector known(SimTK::Vec3(acceleration[0], acceleration[1], acceleration[2]));
    SimTK::Vector result;
    bogie_.matter().calcResidualForceIgnoringConstraints(
        state_, bogie_.system().getMobilityForces(state_, Stage::Dynamics),
        bogie_.system().getRigidBodyForces(state_, Stage::Dynamics), known, result);
    return toEigen(result);
  }

  // Of the residual by the coordinates, without the vehicle's own damper: it is small against the masses, and Newton's
  // method then only takes one iteration more.
  Matrix jacobian(double h) {
    Matrix result = mass_ * (4.0 / (h * h));
    const PerStrut compression = bogie_.compressions(state_);
    for (std::size_t i = 0; i < kStruts; ++i) {
      const component::Tangent tangent = law_.tangent(i, state_.getTime(), compression[i]);
      const Vector direction = toEigen(bogie_.direction(state_, i));
      result += (tangent.stiffness + tangent.damping / h) * direction * direction.transpose();
    }
    return result;
  }

  const HalfBogie& bogie_;
  TrialLaw& law_;
  State& state_;
  Matrix mass_;
  Vector acceleration_;
};

// Step to a time; `accepted` is called after each step that the integrator takes on the way.
void stepTo(
    SimTK::Integrator& integrator, double time, const std::function<void()>& accepted = [] {}) {
  while (integrator.getTime() < time) {
    element::refuseIf<std::runtime_error>(integrator.stepTo(time) == SimTK::Integrator::EndOfSimulation,
                                          "the integrator ends at {:.6g} s", integrator.getTime());
    accepted();
  }
}

bool exceeds(const State& state, double bound) { return !(state.getU().normInf() <= bound); }

// The loop with held loads, of one direction or of six.
template <class History, class Vehicle, class Law, class Partner>
History runLoop(const Scene& scene, const Vehicle& vehicle, Law& law, Partner& exchange, const State& start, int delay,
                double stop_at) {
  SimTK::RungeKuttaMersonIntegrator integrator(vehicle.system());
  prepare(integrator, {1e-8, scene.time(1)});
  integrator.initialize(start);
  History history;
  add(history, vehicle, start, law.held);
  for (std::int64_t n = 1; n <= scene.steps() && !exceeds(integrator.getState(), stop_at); ++n) {
    stepTo(integrator, scene.time(n));
    exchange.send(n * scene.step, motionsOf(vehicle, integrator.getState()));
    if (n >= delay) {
      law.held = exchange.receive((n - delay) * scene.step);
      integrator.reinitialize(Stage::Dynamics, false);  // what it has computed with the forces before is of no use
    }
    add(history, vehicle, integrator.getState(), law.held);
  }
  return history;
}

// Variable steps with trials, of one direction or of six.
template <class History, class Vehicle, class Law>
History runTrials(const Scene& scene, const Vehicle& vehicle, Law& law, const State& start, const VariableStep& options,
                  StepCount* count) {
  law.initialise(0.0, motionsOf(vehicle, start));
  SimTK::RungeKuttaMersonIntegrator integrator(vehicle.system());
  prepare(integrator, options);
  integrator.initialize(start);
  const auto accept = [&] { return law.accept(integrator.getTime(), motionsOf(vehicle, integrator.getState())); };
  History history;
  for (std::int64_t n = 0; n <= scene.steps(); ++n) {
    auto loads = accept();
    stepTo(integrator, scene.time(n), [&] { loads = accept(); });
    add(history, vehicle, integrator.getState(), loads);
  }
  if (count != nullptr) {
    *count = {integrator.getNumStepsTaken(), integrator.getNumStepsAttempted() - integrator.getNumStepsTaken()};
  }
  return history;
}

}  // namespace

std::int64_t Scene::steps() const { return std::llround(duration * 1e9) / step; }

History runVariableStep(const Scene& scene, const std::vector<component::Component>& components,
                        const VariableStep& options, StepCount* count) {
  TrialLaw law(components);
  const HalfBogie bogie(scene.parameters, scene.track, law);
  return runTrials<History>(scene, bogie, law, startOf(scene, bogie), options, count);
}

BushedHistory runVariableStep(const Scene& scene, BushedKind kind, const PerBush<component::SixDirections>& components,
                              const VariableStep& options) {
  BushTrials law(components);
  const BushedVehicle vehicle(kind, scene.parameters, scene.track, law);
  State start = vehicle.restState();
  vehicle.system().realize(start, Stage::Position);
  return runTrials<BushedHistory>(scene, vehicle, law, start, options, nullptr);
}

History runImplicit(const Scene& scene, const std::vector<component::Component>& components, int* iterations) {
  TrialLaw law(components);
  const HalfBogie bogie(scene.parameters, scene.track, law);
  State state = startOf(scene, bogie);
  law.initialise(0.0, bogie.compressions(state));
  Newmark newmark(bogie, law, state);
  History history;
  add(history, bogie, state, law.accept(0.0, bogie.compressions(state)));
  int sum = 0;
  for (std::int64_t n = 1; n <= scene.steps(); ++n) {
    sum += newmark.step(scene.time(n));
    add(history, bogie, state, law.accept(state.getTime(), bogie.compressions(state)));
  }
  if (iterations != nullptr) {
    *iterations = sum;
  }
  return history;
}

History runExchange(const Scene& scene, ForceExchange& exchange, int delay, double stop_at) {
  HeldLoads<double, PerStrut> law;
  const HalfBogie bogie(scene.parameters, scene.track, law);
  const State start = startOf(scene, bogie);
  exchange.send(0, bogie.compressions(start));
  law.held = exchange.receive(0);
  return runLoop<History>(scene, bogie, law, exchange, start, delay, stop_at);
}

BushedHistory runExchange(const Scene& scene, BushedKind kind, WrenchExchange& exchange, int delay) {
  constexpr double kNoBound = 1e9;
  HeldLoads<Eigen::Isometry3d, PerBush<component::Wrench>> law;
  const BushedVehicle vehicle(kind, scene.parameters, scene.track, law);
  State start = vehicle.restState();
  exchange.send(0, vehicle.motions(start));
  law.held = exchange.receive(0);
  return runLoop<BushedHistory>(scene, vehicle, law, exchange, start, delay, kNoBound);
}

}  // namespace rubber_suspension::vehicle
