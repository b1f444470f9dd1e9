// The rig model about elements that were found without it.
#include "command/rig_of_logs.h"

#include <set>

#include "gap/simulate.h"
#include "log/even_blocks.h"
#include "rubber_suspension/measurement/faults.h"
#include "rubber_suspension/measurement/prepared_log.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::command {
namespace {

constexpr std::size_t kShortest = 100;  // samples of a record

// Gain, delays and a zero of the displacement look like the parameters that are sought.
io::RigTolerances withoutParameters(io::RigTolerances tolerances) {
  tolerances.gain = tolerances.delay = tolerances.clock = tolerances.displacement_zero = {0.0, false};
  return tolerances;
}

gap::Forces simulateOver(const std::vector<element::ElementDescription>& elements, std::vector<log::Record> records,
                         const std::vector<Eigen::VectorXd>& displacements) {
  for (std::size_t r = 0; r < records.size(); ++r) {
    records[r].displacement = displacements[r];
    records[r].raw_displacement = displacements[r];
  }
  return gap::simulateEach(elements, records);
}

// Those that a record has sample by sample.
std::vector<std::size_t> usable(const std::vector<log::Log>& logs, const RecordsOfLogs& all,
                                std::vector<log::Record>& records) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    if (all[i] && static_cast<std::size_t>(all[i]->size()) == logs[i].size() && log::stretchesOf(logs[i]).size() == 1) {
      places.push_back(i);
      records.push_back(*all[i]);
    }
  }
  return places;
}

// The zeros of all logs but for what they have in common.
void addZeros(const std::vector<log::Log>& logs, std::vector<Eigen::MatrixXd>& columns) {
  for (std::size_t i = 1; i < logs.size(); ++i) {
    Eigen::MatrixXd wider(static_cast<Eigen::Index>(logs[i].size()), columns[i].cols() + 1);
    wider << columns[i], Eigen::VectorXd::Ones(wider.rows());
    columns[i] = wider;
  }
}

}  // namespace

std::vector<log::Log> repairedLogs(const std::vector<log::Log>& logs, std::vector<measurement::RigFinding>& findings) {
  std::vector<log::Log> result = logs;
  for (log::Log& log : result) {
    if (log.size() < kShortest) {
      continue;
    }
    const measurement::Faults faults = measurement::findFaults(log);
    if (!faults.findings.empty()) {
      log = measurement::repaired(log, faults);
      findings.insert(findings.end(), faults.findings.begin(), faults.findings.end());
    }
  }
  return result;
}

RecordsOfLogs recordsOf(const std::vector<log::Log>& logs) {
  RecordsOfLogs records;
  for (const log::Log& log : logs) {
    const log::Log stretch = log::longestStretch(log);
    records.push_back(stretch.size() < kShortest ? std::nullopt : std::optional(log::makeRecord(stretch)));
  }
  return records;
}

RigOfLogs rigOfLogs(const std::vector<element::ElementDescription>& elements, const io::RigTolerances& tolerances,
                    const std::vector<log::Log>& logs, const RecordsOfLogs& all) {
  std::vector<log::Record> records;
  const std::vector<std::size_t> places = usable(logs, all, records);
  const gap::Forces simulated = gap::simulateEach(elements, records);
  const auto simulate = [&](const std::vector<Eigen::VectorXd>& displacements) {
    return simulateOver(elements, records, displacements);
  };
  const io::RigTolerances own = withoutParameters(tolerances);
  const measurement::RigModel rig(records, {}, own);
  const std::vector<measurement::RigFit> fits = rig.fitAll(simulated, simulate);
  RigOfLogs result;
  std::set<std::size_t> running;
  bool zeros = false;
  for (std::size_t r = 0; r < records.size(); ++r) {
    for (const measurement::RigFinding& finding : rig.findings(r, fits[r])) {
      const bool zero = finding.finding == measurement::finding::kForceZero && logs.size() > 1;
      const bool start = finding.finding == measurement::finding::kRunningStart;
      zeros = zeros || zero;
      if (start) {
        running.insert(r);
      }
      if (zero || start) {
        result.findings.push_back(finding);
      }
    }
  }
  if (result.findings.empty()) {
    return result;
  }
  const auto states = measurement::initialStates(records, own, simulated, simulate);
  result.columns.resize(logs.size());
  for (std::size_t i = 0; i < logs.size(); ++i) {
    result.columns[i].resize(static_cast<Eigen::Index>(logs[i].size()), 0);
  }
  for (const std::size_t r : running) {
    result.columns[places[r]] = states[r];
  }
  if (zeros) {
    addZeros(logs, result.columns);
  }
  return result;
}

}  // namespace rubber_suspension::command
