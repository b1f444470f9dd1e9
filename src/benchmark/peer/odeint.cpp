// Boost.odeint on the library's work.
#include <array>
#include <boost/numeric/odeint.hpp>
#include <numeric>

#include "benchmark/peer/peers.h"

namespace rubber_suspension::benchmark {
namespace {

using State = std::array<double, 5>;

auto systemOf(const PeerWork& work, const double& velocity) {
  return [&work, &velocity](const State& force, State& rate, double /*time*/) {
    maxwellRates(work, velocity, force.data(), rate.data());
  };
}

double sumOf(const State& state) { return std::accumulate(state.begin(), state.end(), 0.0); }

}  // namespace

void odeintRungeKutta4(const PeerWork& work, int substeps, std::vector<double>& force) {
  boost::numeric::odeint::runge_kutta4<State> stepper;
  State state{};
  double velocity = 0.0;
  const auto system = systemOf(work, velocity);
  for (std::size_t i = 1; i < work.displacement.size(); ++i) {
    velocity = work.velocity(i);
    for (int step = 0; step < substeps; ++step) {
      stepper.do_step(system, state, 0.0, work.dt / substeps);
    }
    force[i] = sumOf(state);
  }
}

void odeintDormandPrince(const PeerWork& work, std::vector<double>& force) {
  namespace odeint = boost::numeric::odeint;
  auto stepper = odeint::make_controlled(kAbsoluteTolerance, kRelativeTolerance, odeint::runge_kutta_dopri5<State>());
  State state{};
  double velocity = 0.0;
  const auto system = systemOf(work, velocity);
  for (std::size_t i = 1; i < work.displacement.size(); ++i) {
    velocity = work.velocity(i);
    odeint::integrate_adaptive(stepper, system, state, 0.0, work.dt, 0.5 * work.dt);
    force[i] = sumOf(state);
  }
}

}  // namespace rubber_suspension::benchmark
