// Boost.odeint on the library's work: the forces of the Maxwell elements are the states, dF/dt = k v - F/tau.
#include <boost/numeric/odeint.hpp>
#include <numeric>

#include "benchmark/peer/peers.h"

namespace rubber_suspension::benchmark {
namespace {

namespace odeint = boost::numeric::odeint;

using State = std::array<double, 5>;

constexpr double kRelativeTolerance = 1e-6;
constexpr double kAbsoluteTolerance = 1e-2;  // [N]; the forces are some kN

// `advance` takes a system and a state from one sample to the next.
template <class Advance>
void solve(const PeerWork& work, std::vector<double>& force, Advance advance) {
  State state{};
  double velocity = 0.0;
  const auto system = [&work, &velocity](const State& sum, State& rate, double /*time*/) {
    for (std::size_t k = 0; k < rate.size(); ++k) {
      rate[k] = work.stiffness[k] * velocity - work.rate[k] * sum[k];
    }
  };
  for (std::size_t i = 1; i < work.displacement.size(); ++i) {
    velocity = work.velocity(i);
    advance(system, state);
    force[i] = std::accumulate(state.begin(), state.end(), 0.0);
  }
}

}  // namespace

void odeintRungeKutta4(const PeerWork& work, std::vector<double>& force) {
  constexpr int kSteps = 3;
  odeint::runge_kutta4<State> stepper;
  solve(work, force, [&](const auto& system, State& state) {
    for (int step = 0; step < kSteps; ++step) {
      stepper.do_step(system, state, 0.0, work.dt / kSteps);
    }
  });
}

void odeintDormandPrince(const PeerWork& work, std::vector<double>& force) {
  auto stepper = odeint::make_controlled(kAbsoluteTolerance, kRelativeTolerance, odeint::runge_kutta_dopri5<State>());
  solve(work, force, [&](const auto& system, State& state) {
    odeint::integrate_adaptive(stepper, system, state, 0.0, work.dt, 0.5 * work.dt);
  });
}

}  // namespace rubber_suspension::benchmark
