// Selects excerpts of logs that are too long for a search.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "diagnosis/prepare/log_survey.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::diagnosis::prepare {

/// Logs of one component, shortened for a search.
struct Excerpts {
  std::vector<log::Log> logs;        ///< in the order of recording
  std::vector<log::LeadIn> lead_in;  ///< one per log
  std::vector<log::Log> hold_out;    ///< whole logs, or their beginnings
  std::size_t samples = 0;           ///< number of samples in `logs` and `hold_out`
  std::size_t of = 0;                ///< number of samples in all logs and hold-outs before the selection
};

/// Returns all logs if they have at most `most` samples together. Otherwise each log contributes at most an equal share
/// of `most` or 2000 samples, whichever is more; samples that short logs do not need go to long logs. If a log is
/// longer than its share,
///   - the fit uses the beginning, the window with the largest displacement, and further windows from the smallest to
///     the largest motion, so that all amplitudes are represented. Windows at standstill (less than a tenth of the
///     largest standard deviation) are omitted, and adjacent windows are merged;
///   - a hold-out keeps its beginning, because the later forces of a new component depend on the motion before.
/// The motion between two excerpts becomes a lead-in with at most as many steps as the share has samples. A window
/// contains at least ten cycles if the share is long enough. The name of an excerpt contains its start and end times. A
/// log or excerpt is split at each time gap (log::EvenSteps), and a lead-in bridges the gap. Throws LogError if a log
/// cannot be read or has become shorter since its survey.
Excerpts makeExcerpts(const std::vector<LogSurvey>& logs, const std::vector<LogSurvey>& hold_out, std::size_t most);

/// Displacement and force at even time steps as recorded, before missing samples are bridged.
struct RawChannels {
  Eigen::VectorXd displacement;  ///< [m]
  Eigen::VectorXd force;         ///< [N]
  Eigen::VectorXd counts;        ///< 0 for samples whose force was not measured; empty if every force was measured
  Eigen::VectorXd line;          ///< force that mains or a pump add [N]; empty if they add none
};

/// Returns the channels of the logs, then of the hold-outs, with `line` empty. Throws as log::rawRecord() does.
std::vector<RawChannels> rawChannels(const std::vector<log::Log>& logs, const std::vector<log::Log>& hold_out);

}  // namespace rubber_suspension::diagnosis::prepare
