// The GNU Scientific Library on the library's work.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <array>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "benchmark/peer/peers.h"

namespace rubber_suspension::benchmark {
namespace {

struct Task {
  const PeerWork& work;
  double velocity;
};

int rates(double /*time*/, const double force[], double rate[], void* task) {
  const auto* given = static_cast<const Task*>(task);
  maxwellRates(given->work, given->velocity, force, rate);
  return GSL_SUCCESS;
}

}  // namespace

void gslFehlberg(const PeerWork& work, std::vector<double>& force) {
  std::array<double, 5> state{};
  Task task{work, 0.0};
  gsl_odeiv2_system system{rates, nullptr, state.size(), &task};
  const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rkf45, 0.5 * work.dt, kAbsoluteTolerance,
                                    kRelativeTolerance),
      gsl_odeiv2_driver_free);
  for (std::size_t i = 1; i < work.displacement.size(); ++i) {
    task.velocity = work.velocity(i);
    double time = 0.0;
    gsl_odeiv2_driver_reset(driver.get());
    if (gsl_odeiv2_driver_apply(driver.get(), &time, work.dt, state.data()) != GSL_SUCCESS) {
      throw std::runtime_error("GSL gave up");
    }
    force[i] = std::accumulate(state.begin(), state.end(), 0.0);
  }
}

}  // namespace rubber_suspension::benchmark
