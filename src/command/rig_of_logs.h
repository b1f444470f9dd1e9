// Faults of the rig in logs from which parameters are to be found.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::command {

/// The rig's part in a set of logs.
struct RigOfLogs {
  std::vector<Eigen::MatrixXd> columns;  ///< as fit::IdentificationOptions::rig; empty where nothing was found
  std::vector<measurement::RigFinding> findings;
};

/// Logs whose samples that a channel did not measure are bridged; what was found is added.
std::vector<log::Log> repairedLogs(const std::vector<log::Log>& logs, std::vector<measurement::RigFinding>& findings);

/// The longest stretch of each log without time gaps, as a record; nothing of one with less than 100 samples.
using RecordsOfLogs = std::vector<std::optional<log::Record>>;
RecordsOfLogs recordsOf(const std::vector<log::Log>& logs);

/// About these elements: zeros of the force that differ from log to log, and what is left from before a log that starts
/// in motion. Logs that are too short or sampled unevenly are taken as they are.
RigOfLogs rigOfLogs(const std::vector<element::ElementDescription>& elements, const io::RigTolerances& tolerances,
                    const std::vector<log::Log>& logs, const RecordsOfLogs& records);

}  // namespace rubber_suspension::command
