// Preparation of logs for fits.
#include "rubber_suspension/measurement/prepared_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/least_squares.h"
#include "rubber_suspension/measurement/faults.h"

namespace rubber_suspension::measurement {
namespace {

constexpr double kFewestUsable = 0.5;  // share; with fewer, fits would rely on interpolated samples
constexpr double kLongestStart = 0.1;  // longest first cycle, as a share of the log

// Returns the number of samples in the first cycle of a log that starts in motion; 0 for other logs.
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

// Returns the columns of initial states, scaled by their priors.
Eigen::MatrixXd statesOf(const RigColumns& rig) {
  std::vector<Eigen::Index> chosen;
  for (std::size_t j = 0; j < rig.nuisances.size(); ++j) {
    if (rig.nuisances[j] == Nuisance::initial_state) {
      chosen.push_back(static_cast<Eigen::Index>(j));
    }
  }
  return rig.columns(Eigen::all, chosen) * rig.priors(chosen).asDiagonal();
}

// Returns an orthonormal basis of the columns. Dependent columns, such as exponentials that vanish before the first
// sample that counts, are dropped.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  constexpr double kIndependent = 1e-6;
  return columns.cols() == 0 ? columns : numerics::orthonormalColumns(columns, kIndependent);
}

// Compares findings on single samples by their value, the number of excluded samples.
bool excludesLess(const RigFinding& one, const RigFinding& other) { return one.value < other.value; }

enum class Start { counts, counts_at_rest };

PreparedLog prepare(const log::Log& log, log::LeadIn lead_in, Start start) {
  if (log.force.empty()) {
    return {log::makeRecord(log), {}};  // throws, because the force is missing
  }
  const Faults faults = findFaults(log);
  if (start == Start::counts_at_rest) {
    if (log::Record raw = log::rawRecord(log, lead_in); !log::bothChange(raw)) {
      return {std::move(raw), {}};  // checkBench() reports the constant channel
    }
  }
  PreparedLog prepared{log::makeRecord(repaired(log, faults), std::move(lead_in)), faults.findings};
  log::Record& record = prepared.record;
  Eigen::VectorXd counts = resampled(faults.usable(), log, record).cast<double>();
  const double measured = record.counted();
  if (record.counts.size() > 0) {
    counts.array() *= record.counts.array();
  }
  const Eigen::VectorXd usable = counts;
  counts.head(start == Start::counts ? 0 : samplesOfStart(record)).setZero();
  const auto all = static_cast<double>(record.size());
  if (counts.sum() < all) {
    if (counts.sum() < kFewestUsable * measured) {
      const auto most = std::max_element(faults.findings.begin(), faults.findings.end(), excludesLess);
      throw log::LogError(
          fmt::format("{}: only {:.0f} of {:.0f} samples are usable; accepted: at least half of them: {}", record.name,
                      counts.sum(), measured, most == faults.findings.end() ? "too short" : most->text));
    }
    record.counts = counts;
    // Here the first cycle counts, because the force after it may hardly vary, as in a hold after a ramp.
    record.force_deviation = standardDeviation(record.force, usable);
  }
  return prepared;
}

}  // namespace

PreparedLog prepareLog(const log::Log& log, log::LeadIn lead_in) {
  return prepare(log, std::move(lead_in), Start::counts_at_rest);
}

PreparedLog preparePiece(const log::Log& log) { return prepare(log, {}, Start::counts); }

std::vector<Eigen::MatrixXd> initialStates(const std::vector<gap::PreparedRecord>& records,
                                           const io::RigTolerances& tolerances,
                                           const std::vector<Eigen::VectorXd>& simulated, const Simulate& simulate) {
  std::vector<Eigen::MatrixXd> states;
  const std::vector<RigColumns> all = RigModel(records, {}, tolerances).columns(simulated, simulate);
  for (std::size_t r = 0; r < records.size(); ++r) {
    Eigen::MatrixXd columns = statesOf(all[r]);
    if (records[r].counts.size() > 0) {
      columns.array().colwise() *= records[r].counts.array();
    }
    states.push_back(orthonormal(columns));
  }
  return states;
}

}  // namespace rubber_suspension::measurement
