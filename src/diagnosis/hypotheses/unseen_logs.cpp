// Computes errors on logs that took no part in a fit.
#include "diagnosis/hypotheses/unseen_logs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

#include "element/each.h"
#include "fit/free_in_log.h"
#include "fit/hypothesis_forces.h"
#include "measurement/friction_noise.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/measurement/noise_floor.h"

namespace rubber_suspension::diagnosis::hypotheses {

gap::Forces predict(const fit::ModelParameters& model, const FittedHypothesis& fitted,
                    const std::vector<gap::PreparedRecord>& records) {
  gap::Forces forces;
  for (const gap::PreparedRecord& record : records) {
    const fit::HypothesisForces of_record({record}, model);
    const fit::Hypothesis hypothesis = fit::aboutOtherRecords(fitted.hypothesis, {record});
    forces.push_back(of_record.at(hypothesis, fitted.fit.parameters)->front());
  }
  return forces;
}

UnseenErrors unseenErrors(const fit::ModelParameters& model, const FittedHypothesis& fitted,
                          const std::vector<gap::PreparedRecord>& records) {
  return unseenErrors(fitted.hypothesis, *fit::elementsOf(model, fitted.hypothesis, fitted.fit.parameters),
                      predict(model, fitted, records), records);
}

UnseenErrors unseenErrors(fit::Hypothesis hypothesis, const std::vector<element::ElementDescription>& elements,
                          const gap::Forces& predicted, const std::vector<gap::PreparedRecord>& records) {
  if (hypothesis.free_in_log.by_zero) {
    hypothesis.free_in_log.by_zero = fit::columnOf(element::each(
        records, [&](const gap::PreparedRecord& record) { return fit::byZero(elements, {record}).front(); }));
  }
  if (hypothesis.free_in_log.by_factor) {
    hypothesis.free_in_log.by_factor = fit::columnOf(frictionOfEach(elements, records));
  }
  UnseenErrors errors = partErrorsOf(hypothesis, records, predicted);
  for (gap::PartError& part : errors) {  // a force that is not finite explains no part of the log
    part.error = std::isfinite(part.error) ? part.error : std::numeric_limits<double>::infinity();
  }
  return errors;
}

gap::Forces frictionOfEach(const std::vector<element::ElementDescription>& elements,
                           const std::vector<gap::PreparedRecord>& records) {
  return element::each(records,
                       [&](const gap::PreparedRecord& record) { return fit::frictionOf(elements, {record}).front(); });
}

std::vector<gap::PartError> partErrorsOf(const fit::Hypothesis& hypothesis,
                                         const std::vector<gap::PreparedRecord>& records,
                                         const gap::Forces& simulated) {
  std::vector<gap::OwnUnknowns> own;
  for (std::size_t r = 0; hypothesis.free_in_log.any() && r < records.size(); ++r) {
    own.push_back(hypothesis.free_in_log.unknowns(records[r], r, simulated[r]));
  }
  return gap::partErrors(records, simulated, own);
}

std::vector<double> errorsByLog(const std::vector<gap::PartError>& parts, std::vector<double> otherwise) {
  std::vector<double> sum(otherwise.size(), 0.0);
  std::vector<double> weight(otherwise.size(), 0.0);
  for (const gap::PartError& part : parts) {
    sum[static_cast<std::size_t>(part.log)] += part.weight * part.error;
    weight[static_cast<std::size_t>(part.log)] += part.weight;
  }
  for (std::size_t log = 0; log < otherwise.size(); ++log) {
    otherwise[log] = weight[log] > 0.0 ? sum[log] / weight[log] : otherwise[log];
  }
  return otherwise;
}

fit::PerLogNuisances freeOfNoise(const fit::Hypothesis& hypothesis) {
  return {false, hypothesis.free_in_log.offset, hypothesis.free_in_log.gain};
}

std::vector<double> noiseFloors(const std::vector<element::ElementDescription>& elements,
                                const fit::PerLogNuisances& free, const gap::Forces& simulated,
                                const std::vector<gap::PreparedRecord>& records, const measurement::NoiseLimit& limit) {
  std::vector<double> floors = measurement::frictionNoise(elements, records);
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Eigen::VectorXd residual = records[r].force - simulated[r];
    const gap::PreparedRecord record = free.addedTo(records[r], r, simulated[r]);
    const double left = std::min(measurement::relativeFloor(record, residual), limit.of(record));
    const double all = record.withoutRig(residual).norm() / std::sqrt(record.counted()) / record.force_deviation;
    floors[r] = std::max(left, std::min(floors[r], all));
  }
  return floors;
}

double commonFloor(const std::vector<double>& floors, const std::vector<gap::PreparedRecord>& records) {
  double squares = 0.0;
  double weight = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    squares += records[r].weight * floors[r] * floors[r];
    weight += records[r].weight;
  }
  return std::sqrt(squares / weight);
}

}  // namespace rubber_suspension::diagnosis::hypotheses
