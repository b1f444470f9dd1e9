// Two ways to step a vehicle.
#include "vehicle/simulation.h"

#include <cmath>
#include <functional>
#include <stdexcept>

#include "element/refuse.h"
#include "vehicle/vehicle.h"

namespace rubber_suspension::vehicle {
namespace {

using SimTK::Stage;
using SimTK::State;

// Computes the wrenches of trial steps from the states of the components at the last accepted step.
class Trials final : public WrenchLaw {
 public:
  explicit Trials(const Bushes& components) : components_(components) {}

  void initialise(const Poses& poses) {
    for (std::size_t i = 0; i < components_.size(); ++i) {
      accepted_.push_back(components_[i].makeState());
      wrenches_.push_back(components_[i].initialise(accepted_[i], poses[i]).wrench);
    }
    trial_ = accepted_;
  }

  component::Wrench wrench(std::size_t bush, double time, const Eigen::Isometry3d& pose) override {
    if (time <= time_) {
      return wrenches_[bush];
    }
    trial_[bush].copyFrom(accepted_[bush]);
    return components_[bush].step(trial_[bush], time - time_, pose).wrench;
  }

  const Wrenches& accept(double time, const Poses& poses) {
    for (std::size_t i = 0; i < components_.size() && time > time_; ++i) {
      element::refuseIf<std::runtime_error>(
          !components_[i].holds(components_[i].coordinates(poses[i])),
          "component {} at {:.6g} s: the rotation exceeds the range of rotation vectors or cardan angles", i + 1, time);
      wrenches_[i] = components_[i].step(accepted_[i], time - time_, poses[i]).wrench;
    }
    time_ = time;
    return wrenches_;
  }

 private:
  const Bushes& components_;
  PerBush<component::SixDirectionsState> accepted_;
  PerBush<component::SixDirectionsState> trial_;
  Wrenches wrenches_;
  double time_ = 0.0;
};

class HeldWrenches final : public WrenchLaw {
 public:
  component::Wrench wrench(std::size_t bush, double /*time*/, const Eigen::Isometry3d& /*pose*/) override {
    return held[bush];
  }

  Wrenches held;
};

// Appends a state, and the wrenches that act in this state.
void add(History& history, const Vehicle& vehicle, const State& state, const Wrenches& wrenches) {
  history.time.push_back(state.getTime());
  history.position.emplace_back();
  for (int i = 0; i < state.getQ().size(); ++i) {
    history.position.back().push_back(state.getQ()[i]);
  }
  history.pose.push_back(vehicle.poses(state));
  history.wrench.push_back(wrenches);
}

State startOf(const Scene& scene, const Vehicle& vehicle) {
  State state = vehicle.restState();
  for (std::size_t i = 0; scene.kind != Kind::body && i < scene.kick.size(); ++i) {
    state.updU()[static_cast<int>(i)] = scene.kick[i];
  }
  vehicle.system().realize(state, Stage::Position);
  return state;
}

// Configures the integrator to end steps at the requested time and to return after each of them.
void prepare(SimTK::Integrator& integrator, const VariableStep& options) {
  integrator.setAccuracy(options.accuracy);
  integrator.setMaximumStepSize(options.longest);
  integrator.setAllowInterpolation(false);
  integrator.setReturnEveryInternalStep(true);
}

// Steps to a time [s] and calls `accepted` after each step of the integrator.
void stepTo(SimTK::Integrator& integrator, double time, const std::function<void()>& accepted = [] {}) {
  while (integrator.getTime() < time) {
    element::refuseIf<std::runtime_error>(integrator.stepTo(time) == SimTK::Integrator::EndOfSimulation,
                                          "the integrator cannot continue beyond {:.6g} s", integrator.getTime());
    accepted();
  }
}

}  // namespace

std::int64_t Scene::steps() const { return std::llround(duration * 1e9) / step; }

History runVariableStep(const Scene& scene, const Bushes& components, const VariableStep& options, StepCount* count) {
  Trials law(components);
  const Vehicle vehicle(scene.kind, scene.parameters, scene.track, law);
  const State start = startOf(scene, vehicle);
  law.initialise(vehicle.poses(start));
  SimTK::RungeKuttaMersonIntegrator integrator(vehicle.system());
  prepare(integrator, options);
  integrator.initialize(start);
  const auto accept = [&] { return law.accept(integrator.getTime(), vehicle.poses(integrator.getState())); };
  History history;
  for (std::int64_t n = 0; n <= scene.steps(); ++n) {
    Wrenches wrenches = accept();
    stepTo(integrator, scene.time(n), [&] { wrenches = accept(); });
    add(history, vehicle, integrator.getState(), wrenches);
  }
  if (count != nullptr) {
    *count = {integrator.getNumStepsTaken(), integrator.getNumStepsAttempted() - integrator.getNumStepsTaken()};
  }
  return history;
}

void LibraryExchange::send(std::int64_t stamp, const Poses& poses) {
  Wrenches wrenches;
  for (std::size_t i = 0; i < streams_.size(); ++i) {
    const component::StreamWrench answer =
        streams_[i].push(stamp, poses[i].translation(), Eigen::Quaterniond(poses[i].linear()));
    element::refuseIf<std::runtime_error>(!component::isAccepted(answer.acceptance),
                                          "the motion of component {} at {} ns was not accepted", i + 1, stamp);
    wrenches.push_back(answer.force.wrench);
  }
  answers_.emplace_back(stamp, wrenches);
}

Wrenches LibraryExchange::receive(std::int64_t stamp) {
  while (!answers_.empty() && answers_.front().first < stamp) {
    answers_.pop_front();
  }
  element::refuseIf<std::runtime_error>(answers_.empty() || answers_.front().first != stamp,
                                        "no displacement was sent at {} ns", stamp);
  return answers_.front().second;
}

History runExchange(const Scene& scene, Exchange& exchange, int delay) {
  HeldWrenches law;
  const Vehicle vehicle(scene.kind, scene.parameters, scene.track, law);
  const State start = startOf(scene, vehicle);
  exchange.send(0, vehicle.poses(start));
  law.held = exchange.receive(0);
  SimTK::RungeKuttaMersonIntegrator integrator(vehicle.system());
  prepare(integrator, {1e-8, scene.time(1)});
  integrator.initialize(start);
  History history;
  add(history, vehicle, start, law.held);
  for (std::int64_t n = 1; n <= scene.steps(); ++n) {
    stepTo(integrator, scene.time(n));
    exchange.send(n * scene.step, vehicle.poses(integrator.getState()));
    if (n >= delay) {
      law.held = exchange.receive((n - delay) * scene.step);
      integrator.reinitialize(Stage::Dynamics, false);  // discards results that used the last wrenches
    }
    add(history, vehicle, integrator.getState(), law.held);
  }
  return history;
}

}  // namespace rubber_suspension::vehicle
