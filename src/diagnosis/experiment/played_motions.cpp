// Simulates motions after the turning points of the logs.
#include "diagnosis/experiment/played_motions.h"

#include <algorithm>
#include <cmath>

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::diagnosis::experiment {
namespace {

constexpr double kRipple = 0.02;  // fraction of the range of a log; smaller reversals hardly soften the rubber

// Returns the samples at which the displacement reverses by more than the ripple, and the last sample.
std::vector<Eigen::Index> turningPoints(const Eigen::VectorXd& z) {
  const double ripple = kRipple * (z.maxCoeff() - z.minCoeff());
  std::vector<Eigen::Index> turns;
  Eigen::Index lowest = 0;
  Eigen::Index highest = 0;
  int direction = 0;
  for (Eigen::Index i = 1; i < z.size(); ++i) {
    lowest = z[i] < z[lowest] ? i : lowest;
    highest = z[i] > z[highest] ? i : highest;
    if (direction >= 0 && z[highest] - z[i] > ripple) {
      turns.push_back(highest);
      direction = -1;
      lowest = i;
    } else if (direction <= 0 && z[i] - z[lowest] > ripple) {
      turns.push_back(lowest);
      direction = 1;
      highest = i;
    }
  }
  turns.push_back(z.size() - 1);
  return turns;
}

}  // namespace

PlayedMotions::PlayedMotions(const std::vector<gap::PreparedRecord>& logs) {
  for (const log::Record& log : logs) {
    Eigen::Index before = 0;
    turns_.push_back({0.0, log.displacement[0]});
    for (const Eigen::Index turn : turningPoints(log.displacement)) {
      if (turn > before) {
        turns_.push_back({log.dt * static_cast<double>(turn - before), log.displacement[turn]});
        before = turn;
      }
    }
  }
}

std::vector<Eigen::VectorXd> PlayedMotions::forces(const std::vector<element::ElementDescription>& elements) const {
  const component::Component component(elements);
  component::ComponentState after_logs = component.makeState();
  component.initialise(after_logs, 0.0);
  for (const Turn& turn : turns_) {
    if (turn.after > 0.0) {
      component.step(after_logs, turn.after, turn.displacement);
    } else {
      component.relax(after_logs, turn.displacement);
    }
  }
  std::vector<Eigen::VectorXd> result;
  component::ComponentState state = component.makeState();
  for (const Experiment* motion : motions_) {
    state.copyFrom(after_logs);
    const Eigen::Index samples = (motion->displacement.size() - 1) / motion->stride;
    const Eigen::VectorXd z = Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<>>(
        motion->displacement.data() + motion->stride, samples, Eigen::InnerStride<>(motion->stride));
    Eigen::VectorXd force(samples);
    component.relax(state, motion->displacement[0]);
    component.simulate(state, motion->dt * static_cast<double>(motion->stride), z.data(),
                       static_cast<std::size_t>(samples), force.data());
    result.push_back(std::move(force));
  }
  return result;
}

}  // namespace rubber_suspension::diagnosis::experiment
