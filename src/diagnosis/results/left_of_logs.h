// Gaps of the written and of the configured component on each log, with the same errors of the rig removed.
#pragma once

#include <vector>

#include "gap/simulate.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Errors of the rig in a log, equal for all components.
struct RigOfLog {
  double gain = 0.0;   ///< of the recorded force, from the findings [-]
  double delay = 0.0;  ///< of the recorded force behind the displacement, from the findings [s]
};

/// Returns gain and delay of each record from the findings.
std::vector<RigOfLog> rigOfLogs(const std::vector<gap::PreparedRecord>& records,
                                const std::vector<measurement::RigFinding>& findings);

/// Returns the gaps of two components on each record, without the gain and delay of the record, and with an offset and,
/// for a log that starts in motion, an initial state fitted to each component.
std::vector<LeftOfLog> leftOfLogs(const std::vector<gap::PreparedRecord>& records, const std::vector<RigOfLog>& rig,
                                  const gap::Forces& configured, const gap::Forces& written);

/// Returns the excess of the squared gaps of the written component over the allowed ones: the sum over single logs,
/// plus that of the mean over all logs. 0 if no gap is too large.
double excessOf(const std::vector<LeftOfLog>& logs);

/// Returns the increase of the mean squared gap that is allowed over all logs: a hundredth of the accepted error
/// squared. A written offset changes no gap, because an offset is fitted to each log.
double asMuchAs();

/// Returns the log with the largest excess; the mean as "all logs" if no single log has one.
LeftOfLog worstOf(const std::vector<LeftOfLog>& logs);

}  // namespace rubber_suspension::diagnosis::results
