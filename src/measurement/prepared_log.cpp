// A log made ready for fits.
#include "rubber_suspension/measurement/prepared_log.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "rubber_suspension/measurement/faults.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::measurement {
namespace {

constexpr double kFewestUsable = 0.5;  // of the samples: below, what is judged would be mostly bridges
constexpr double kLongestStart = 0.1;  // of the log, for its first cycle

// The first samples of a log that starts in motion: one cycle of its mean frequency.
Eigen::Index samplesOfStart(const log::Record& record) {
  if (!startsInMotion(record)) {
    return 0;
  }
  const double cycle = 1.0 / (record.mean_frequency * record.dt);
  return static_cast<Eigen::Index>(std::min(cycle, kLongestStart * static_cast<double>(record.size())));
}

double standardDeviation(const Eigen::VectorXd& values, const Eigen::VectorXd& counts) {
  const double count = counts.sum();
  const double mean = values.dot(counts) / count;
  return std::sqrt((values.array() - mean).square().matrix().dot(counts) / count);
}

}  // namespace

PreparedLog prepareLog(const log::Log& log) {
  if (log.force.empty()) {
    return {log::makeRecord(log), {}};  // which says what is missing
  }
  const Faults faults = findFaults(log);
  PreparedLog prepared{log::makeRecord(repaired(log, faults)), faults.findings};
  log::Record& record = prepared.record;
  Eigen::VectorXd counts = resampled(faults.usable(), log, record).cast<double>();
  counts.head(samplesOfStart(record)).setZero();
  const auto all = static_cast<double>(record.size());
  if (counts.sum() < all) {
    if (counts.sum() < kFewestUsable * all) {
      throw log::LogError(fmt::format("{}: {:.0f} of {} samples are usable; needed is one half: {}", record.name,
                                      counts.sum(), record.size(),
                                      faults.findings.empty() ? "too short" : faults.findings.front().text));
    }
    record.counts = counts;
    record.force_deviation = standardDeviation(record.force, counts);
  }
  return prepared;
}

Eigen::MatrixXd freeNuisances(const log::Record& record, const io::RigTolerances& tolerances, bool zero_counts) {
  const RigModel rig({record}, {}, tolerances);
  const RigColumns all = rig.columns({record.force}, {}).front();
  std::vector<Eigen::Index> chosen;
  for (std::size_t j = 0; j < all.nuisances.size(); ++j) {
    const bool zero = all.nuisances[j] == Nuisance::force_zero && !zero_counts;
    if (zero || all.nuisances[j] == Nuisance::initial_state) {
      chosen.push_back(static_cast<Eigen::Index>(j));
    }
  }
  Eigen::MatrixXd columns(record.size(), static_cast<Eigen::Index>(chosen.size()));
  for (std::size_t j = 0; j < chosen.size(); ++j) {
    columns.col(static_cast<Eigen::Index>(j)) = all.columns.col(chosen[j]);
  }
  if (record.counts.size() > 0) {
    columns.array().colwise() *= record.counts.array();
  }
  if (chosen.empty()) {
    return columns;  // a zero that is a cause, of a log that starts at rest; a factorisation needs a column
  }
  // Without columns that others stand for, such as exponentials that are over before the first sample that counts.
  constexpr double kIndependent = 1e-6;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(columns.rows(), columns.cols());
  factor.setThreshold(kIndependent);
  factor.compute(columns);
  return factor.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), factor.rank());
}

}  // namespace rubber_suspension::measurement
