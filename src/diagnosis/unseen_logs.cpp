// Errors on unseen logs.
#include "diagnosis/unseen_logs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "diagnosis/augmented.h"
#include "diagnosis/friction_noise.h"
#include "fit/free_in_log.h"
#include "fit/hypothesis_forces.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/measurement/noise_floor.h"

namespace rubber_suspension::diagnosis {

gap::Forces predict(const fit::ModelParameters& model, const FittedHypothesis& fitted,
                    const std::vector<log::Record>& records) {
  gap::Forces forces;
  for (const log::Record& record : records) {
    const fit::HypothesisForces of_record({record}, model);
    const fit::Hypothesis hypothesis = fit::aboutOtherRecords(fitted.hypothesis, {record});
    forces.push_back(of_record.at(hypothesis, fitted.fit.parameters)->front());
  }
  return forces;
}

UnseenErrors unseenErrors(const fit::ModelParameters& model, const FittedHypothesis& fitted,
                          const std::vector<log::Record>& records, const NoiseLimit& limit) {
  const gap::Forces predicted = predict(model, fitted, records);
  UnseenErrors errors;
  errors.parts = partErrorsOf(fitted.hypothesis, records, predicted);
  for (gap::PartError& part : errors.parts) {  // a law that gives way under some motion explains none of it
    part.error = std::isfinite(part.error) ? part.error : std::numeric_limits<double>::infinity();
  }
  errors.gap = gap::gapOfParts(errors.parts);
  errors.noise_floor = commonFloor(noiseFloors(augmentedDescription(model, fitted).allElements(), predicted,
                                               freed(freeOfNoise(fitted.hypothesis), records, predicted), limit),
                                   records);
  return errors;
}

std::vector<log::Record> freed(fit::FreeInLog free, const std::vector<log::Record>& records,
                               const gap::Forces& simulated) {
  if (!free.any()) {
    return records;
  }
  std::vector<log::Record> result;
  for (std::size_t r = 0; r < records.size(); ++r) {
    result.push_back(fit::withFreeInLog(free, records[r], simulated[r]));
  }
  return result;
}

fit::FreeInLog freeOfNoise(const fit::Hypothesis& hypothesis) { return {false, hypothesis.free_in_log.gain}; }

std::vector<gap::PartError> partErrorsOf(const fit::Hypothesis& hypothesis, const std::vector<log::Record>& records,
                                         const gap::Forces& simulated) {
  return gap::partErrors(freed(hypothesis.free_in_log, records, simulated), simulated);
}

std::vector<double> noiseFloors(const std::vector<element::ElementDescription>& elements, const gap::Forces& simulated,
                                const std::vector<log::Record>& records, const NoiseLimit& limit) {
  std::vector<double> floors = frictionNoise(elements, records);
  for (std::size_t r = 0; r < records.size(); ++r) {
    const log::Record& record = records[r];
    const Eigen::VectorXd residual = record.force - simulated[r];
    const double left = std::min(measurement::relativeFloor(record, residual), limit.of(record));
    const double all = record.withoutRig(residual).norm() / std::sqrt(record.counted()) / record.force_deviation;
    floors[r] = std::max(left, std::min(floors[r], all));
  }
  return floors;
}

double commonFloor(const std::vector<double>& floors, const std::vector<log::Record>& records) {
  double squares = 0.0;
  double weight = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    squares += records[r].weight * floors[r] * floors[r];
    weight += records[r].weight;
  }
  return std::sqrt(squares / weight);
}

}  // namespace rubber_suspension::diagnosis
