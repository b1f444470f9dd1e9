// Simulates planned logs with noise, and predicts which effects a diagnosis of them would find.
#include "rubber_suspension/diagnosis/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include "diagnosis/experiment/confusion.h"
#include "diagnosis/hypotheses/measured_logs.h"
#include "diagnosis/hypotheses/odds.h"
#include "diagnosis/prepare/rig.h"
#include "element/each.h"
#include "fit/parallel.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/measurement/prepared_log.h"

namespace rubber_suspension::diagnosis {
namespace {

// Simulates the force of the component on one log after the other, and adds noise.
void simulateForces(const component::Component& component, double noise, std::vector<log::Log>& logs) {
  component::ComponentState state = component.makeState();
  std::mt19937 generator(1);
  for (std::size_t l = 0; l < logs.size(); ++l) {
    log::Log& log = logs[l];
    log.force.assign(log.size(), 0.0);
    log.force[0] =
        (l == 0 ? component.initialise(state, log.displacement[0]) : component.relax(state, log.displacement[0])).total;
    for (std::size_t i = 1; i < log.size(); ++i) {
      log.force[i] = component.step(state, log.time(i) - log.time(i - 1), log.displacement[i]).total;
    }
    const Eigen::Map<const Eigen::VectorXd> force(log.force.data(), static_cast<Eigen::Index>(log.size()));
    std::normal_distribution<double> normal(0.0, noise * gap::standardDeviation(force));
    for (double& value : log.force) {
      value += normal(generator);
    }
  }
}

PlannedLog plannedLog(const log::Record& record) {
  const Eigen::Index steps = record.size() - 1;
  PlannedLog planned;
  planned.log = record.name;
  planned.duration = record.duration();
  planned.dt = record.dt;
  planned.largest_displacement = record.displacement.cwiseAbs().maxCoeff();
  planned.highest_rate =
      (record.displacement.tail(steps) - record.displacement.head(steps)).cwiseAbs().maxCoeff() / record.dt;
  planned.largest_force = record.force.cwiseAbs().maxCoeff();
  return planned;
}

}  // namespace

Plan plan(const io::ComponentDescription& component, const std::vector<log::Log>& logs, const PlanOptions& options) {
  if (logs.empty()) {
    throw log::LogError("no programme is given; accepted: at least one programme");
  }
  std::vector<log::Log> simulated = logs;
  simulateForces(component::Component(component.allElements()), options.noise, simulated);
  std::vector<log::Record> records(simulated.size());
  fit::parallelFor(records.size(), options.threads,
                   [&](std::size_t i) { records[i] = measurement::prepareLog(simulated[i]).record; });
  for (const log::Record& record : records) {
    if (!log::bothChange(record)) {
      throw log::LogError(record.name + ": the displacement does not change; accepted: a programme with motion");
    }
  }
  const fit::ModelParameters model(component, fit::Level::specification);
  fit::Fitter fitter(
      prepare::withRigPriors(model, component.rig.value_or(io::RigTolerances{}), hypotheses::errorScale(),
                             {records.begin(), records.end()}, {}, prepare::RigScatter::as_tolerated)
          .training,
      model, hypotheses::errorScale().oneOfSheet());
  Plan result;
  result.component = component.name;
  result.logs = element::each(fitter.records(), plannedLog);
  result.could_show = experiment::couldShow(hypotheses::implanted(fitter, options.noise, options.threads), options.size,
                                            "option --effect-size");
  return result;
}

}  // namespace rubber_suspension::diagnosis
