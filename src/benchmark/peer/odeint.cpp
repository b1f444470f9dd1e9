// Boost.odeint on the library's work: the forces of the Maxwell elements are the states, dF/dt = k v - F/tau.
#include <boost/numeric/odeint.hpp>
#include <numeric>

#include "benchmark/peer/peers.h"

namespace rubber_suspension::benchmark {

void odeintDormandPrince(const PeerWork& work, std::vector<double>& force) {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 5>;
  constexpr double kRelativeTolerance = 1e-6;
  constexpr double kAbsoluteTolerance = 1e-2;  // [N]; the forces are some kN
  auto stepper = odeint::make_controlled(kAbsoluteTolerance, kRelativeTolerance, odeint::runge_kutta_dopri5<State>());
  State state{};
  for (std::size_t i = 1; i < work.displacement.size(); ++i) {
    const auto system = [&work, velocity = work.velocity(i)](const State& forces, State& rate, double /*time*/) {
      for (std::size_t k = 0; k < rate.size(); ++k) {
        rate[k] = work.stiffness[k] * velocity - work.rate[k] * forces[k];
      }
    };
    odeint::integrate_adaptive(stepper, system, state, 0.0, work.dt, 0.5 * work.dt);
    force[i] = std::accumulate(state.begin(), state.end(), 0.0);
  }
}

}  // namespace rubber_suspension::benchmark
