// Compares the gaps of the written and the configured component on each log, after removing the same errors of the rig.
#pragma once

#include <vector>

#include "gap/simulate.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Errors of the rig in a log, which are removed for each component alike.
struct RigOfLog {
  double gain = 0.0;   ///< gain of the recorded force [-]
  double delay = 0.0;  ///< delay of the recorded force relative to the displacement [s]
};

/// Returns the gain and the delay that the findings state for each record.
std::vector<RigOfLog> rigOfLogs(const std::vector<gap::PreparedRecord>& records,
                                const std::vector<measurement::RigFinding>& findings);

/// Returns the gaps of two components on each record. The gain and the delay of the record are removed. An offset and,
/// if the log starts in motion, an initial state are fitted for each component.
std::vector<LeftOfLog> leftOfLogs(const std::vector<gap::PreparedRecord>& records, const std::vector<RigOfLog>& rig,
                                  const gap::Forces& configured, const gap::Forces& written);

/// Returns by how much the squared gaps of the written component exceed the allowed ones: the sum of the excess of each
/// log and of the excess of the mean over all logs. Returns 0 if no gap is too large.
double excessOf(const std::vector<LeftOfLog>& logs);

/// Returns the allowed increase of the mean squared gap over all logs: 1 % of the squared accepted error. A written
/// offset changes no gap, because an offset is fitted to each log.
double asMuchAs();

/// Returns the log with the largest excess. If no single log exceeds its limit, returns the mean as "all logs".
LeftOfLog worstOf(const std::vector<LeftOfLog>& logs);

}  // namespace rubber_suspension::diagnosis::results
