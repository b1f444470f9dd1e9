// Gaps of the written and of the configured component on each log, with the same errors of the rig removed.
#pragma once

#include <vector>

#include "gap/simulate.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Errors of the rig in a log, equal for all components.
struct RigOfLog {
  double gain = 0.0;   ///< of the recorded force, as a finding says [-]
  double delay = 0.0;  ///< of the recorded force behind the displacement, likewise [s]
};

/// Gain and delay of each record by the findings.
std::vector<RigOfLog> rigOfLogs(const std::vector<gap::PreparedRecord>& records,
                                const std::vector<measurement::RigFinding>& findings);

/// Residual of each of two components on each record, without the gain and delay of the record, and with an offset and,
/// for a log that starts in motion, an initial state fitted to each component.
std::vector<LeftOfLog> leftOfLogs(const std::vector<gap::PreparedRecord>& records, const std::vector<RigOfLog>& rig,
                                  const gap::Forces& configured, const gap::Forces& written);

/// By how much the written component leaves too much: over each log, the squared gap above the one allowed; over all
/// logs together likewise. 0: nowhere.
double excessOf(const std::vector<LeftOfLog>& logs);

/// A square by which nothing is left more: a hundredth of the accepted one. An offset that is written leaves as much as
/// none, since one is fitted to each log.
double asMuchAs();

/// The log with the largest excess; "all logs" where only all of them together have one.
LeftOfLog worstOf(const std::vector<LeftOfLog>& logs);

}  // namespace rubber_suspension::diagnosis::results
