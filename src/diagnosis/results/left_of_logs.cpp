// Compares the gaps of two components on each log.
#include "diagnosis/results/left_of_logs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnosis/judge/numbers.h"
#include "numerics/difference_quotient.h"
#include "numerics/gram.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::diagnosis::results {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Returns the columns of the least-squares system that are free in a log: a constant and, if the log starts in motion,
// decays from the initial state. Samples that do not count are 0.
Eigen::MatrixXd freeColumns(const gap::PreparedRecord& record, const VectorXd& counts, const VectorXd& simulated) {
  const measurement::RigColumns rig =
      measurement::RigModel({record}, {}, io::RigTolerances{}).columns({simulated}, {}).front();
  std::vector<Index> states;
  for (std::size_t j = 0; j < rig.nuisances.size(); ++j) {
    if (rig.nuisances[j] == measurement::Nuisance::initial_state) {
      states.push_back(static_cast<Index>(j));
    }
  }
  Eigen::MatrixXd columns(record.size(), 1 + static_cast<Index>(states.size()));
  columns << counts, counts.asDiagonal() * rig.columns(Eigen::all, states);
  return columns;
}

// Returns the residual after a fit of the free columns, divided by the standard deviation of the force.
VectorXd residualOf(const gap::PreparedRecord& record, const VectorXd& counts, const RigOfLog& rig,
                    const Eigen::MatrixXd& free, const VectorXd& simulated) {
  const VectorXd late = simulated - rig.delay / record.dt * numerics::slopesOf(simulated);
  const VectorXd residual = (record.force - (1.0 + rig.gain) * late).cwiseProduct(counts) / record.force_deviation;
  // Several similar decays in a short log make the equations singular.
  return residual - free * numerics::solveSymmetric(numerics::gramOf(free), VectorXd(free.transpose() * residual));
}

// Returns the standard error of the mean of the difference of two squares, estimated from ten blocks of the log.
double standardError(const VectorXd& difference) {
  constexpr Index kTenths = 10;
  Eigen::Array<double, kTenths, 1> means;
  for (Index b = 0; b < kTenths; ++b) {
    const Index first = difference.size() * b / kTenths;
    means[b] = difference.segment(first, difference.size() * (b + 1) / kTenths - first).mean();
  }
  return std::sqrt((means - means.mean()).square().sum() / (kTenths * (kTenths - 1.0)));
}

double square(double value) { return value * value; }

double excessOfLog(const LeftOfLog& log) { return square(log.written) - square(log.configured) - log.allowed; }

}  // namespace

std::vector<RigOfLog> rigOfLogs(const std::vector<gap::PreparedRecord>& records,
                                const std::vector<measurement::RigFinding>& findings) {
  std::vector<RigOfLog> rig(records.size());
  for (const measurement::RigFinding& finding : findings) {
    for (std::size_t r = 0; r < records.size(); ++r) {
      if (records[r].name == finding.log) {
        rig[r].gain += finding.finding == measurement::finding::kSensorGain ? finding.value : 0.0;
        rig[r].delay += finding.finding == measurement::finding::kDelay ? finding.value : 0.0;
      }
    }
  }
  return rig;
}

std::vector<LeftOfLog> leftOfLogs(const std::vector<gap::PreparedRecord>& records, const std::vector<RigOfLog>& rig,
                                  const gap::Forces& configured, const gap::Forces& written) {
  std::vector<LeftOfLog> logs;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const gap::PreparedRecord& record = records[r];
    const VectorXd counts = record.counts.size() > 0 ? record.counts : VectorXd::Ones(record.size());
    const Eigen::MatrixXd free = freeColumns(record, counts, configured[r]);
    const auto squares = [&](const VectorXd& simulated) -> VectorXd {
      return residualOf(record, counts, rig[r], free, simulated).cwiseAbs2() *
             (static_cast<double>(record.size()) / record.counted());
    };
    const VectorXd before = squares(configured[r]);
    const VectorXd after = squares(written[r]);
    const double allowed = std::max(square(judge::fittedNumbers().accepted), 2.0 * standardError(after - before));
    logs.push_back({record.name, std::sqrt(before.mean()), std::sqrt(after.mean()), allowed});
  }
  return logs;
}

double excessOf(const std::vector<LeftOfLog>& logs) {
  double excess = 0.0;
  double pooled = 0.0;
  for (const LeftOfLog& log : logs) {
    excess += std::max(0.0, excessOfLog(log));
    pooled += square(log.written) - square(log.configured);
  }
  pooled /= static_cast<double>(std::max<std::size_t>(logs.size(), 1));
  return excess + std::max(0.0, pooled - asMuchAs());
}

double asMuchAs() { return 0.01 * square(judge::fittedNumbers().accepted); }

LeftOfLog worstOf(const std::vector<LeftOfLog>& logs) {
  LeftOfLog worst = *std::max_element(
      logs.begin(), logs.end(), [](const LeftOfLog& a, const LeftOfLog& b) { return excessOfLog(a) < excessOfLog(b); });
  if (excessOfLog(worst) > 0.0) {
    return worst;
  }
  const auto pooled = [&](double LeftOfLog::* gap) {
    return std::sqrt(std::accumulate(logs.begin(), logs.end(), 0.0,
                                     [&](double sum, const LeftOfLog& log) { return sum + square(log.*gap); }) /
                     static_cast<double>(logs.size()));
  };
  return {"all logs", pooled(&LeftOfLog::configured), pooled(&LeftOfLog::written), 0.0};
}

}  // namespace rubber_suspension::diagnosis::results
