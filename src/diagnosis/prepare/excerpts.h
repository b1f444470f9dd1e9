// Excerpts of logs that are too long for a search.
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
  std::vector<log::Log> hold_out;    ///< whole, or the beginning
  std::size_t samples = 0;           ///< in `logs` and `hold_out`
  std::size_t of = 0;                ///< in the logs and hold-outs before the selection
};

/// Returns all logs if they have at most `most` samples together. Otherwise no log contributes more than an equal
/// share, with a minimum of 2000 samples; what short logs do not need goes to the long ones. Of a log longer than its
/// share,
///   - the fit gets the beginning, the window with the largest displacement, and further windows from the smallest to
///     the largest motion, so that all amplitudes are represented. Windows at standstill (less than a tenth of the
///     largest standard deviation) are omitted; adjacent windows are merged;
///   - a hold-out keeps its beginning, because later forces of a new component depend on the motion before.
/// The motion between two excerpts becomes a lead-in with at most as many steps as the share has samples. A window
/// contains at least ten cycles if the share is long enough. The name of an excerpt contains its times.
/// A log or excerpt is split at each time gap (log::EvenSteps), and a lead-in of one step bridges the gap.
/// Throws LogError if a log cannot be read or has become shorter since its survey.
Excerpts makeExcerpts(const std::vector<LogSurvey>& logs, const std::vector<LogSurvey>& hold_out, std::size_t most);

/// Both channels at even time steps as recorded, before missing samples are bridged.
struct RawChannels {
  Eigen::VectorXd displacement;  ///< [m]
  Eigen::VectorXd force;         ///< [N]
  Eigen::VectorXd counts;        ///< 0 where no force was measured; empty if it was measured everywhere
  Eigen::VectorXd line;          ///< part of the force caused by mains or a pump [N]; empty if there is none
};

/// Returns the channels of the logs, then of the hold-outs, without lines. Throws as log::rawRecord() does.
std::vector<RawChannels> rawChannels(const std::vector<log::Log>& logs, const std::vector<log::Log>& hold_out);

}  // namespace rubber_suspension::diagnosis::prepare
