// Excerpts of logs that are longer than a search takes.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "diagnosis/prepare/log_survey.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::diagnosis::prepare {

/// Logs of one component as the search takes them.
struct Excerpts {
  std::vector<log::Log> logs;        ///< in the order of recording
  std::vector<log::LeadIn> lead_in;  ///< of each of them
  std::vector<log::Log> hold_out;    ///< each from the beginning of its log
  std::size_t samples = 0;           ///< of all of these
  std::size_t of = 0;                ///< of all logs and hold-outs that were given
};

/// All of the logs where they have `most` samples or fewer together. Otherwise no log gives more than a fair share:
/// short ones are taken whole, and of the others
///   - a log of the fit gives its beginning, the window with the largest displacement, and further windows from those
///     that move least to those that move most, so that each amplitude of the log is there; windows that stand still
///     (less than a tenth of what moves most) are left out, windows that touch are one excerpt;
///   - a hold-out gives its beginning: what a new component does later depends on what came before.
/// The motion between two excerpts leads the component from one to the other, in no more steps than the share has
/// samples. A window holds at least ten cycles of the log, where the share is long enough. Each excerpt has a note of
/// where it is from, and its name tells the seconds.
/// Behind a time gap (log::EvenSteps) a log or excerpt continues as another, to which the exact step over it leads.
/// Throws LogError where a log is no longer what it was in the survey.
Excerpts makeExcerpts(const std::vector<LogSurvey>& logs, const std::vector<LogSurvey>& hold_out, std::size_t most);

/// Both channels at even steps as they were recorded, before samples that a channel did not measure were bridged.
struct RawChannels {
  Eigen::VectorXd displacement;  ///< [m]
  Eigen::VectorXd force;         ///< [N]
  Eigen::VectorXd counts;        ///< 0 where no force was measured; empty: it was everywhere
  Eigen::VectorXd line;          ///< part of the force that is of mains or a pump [N]; empty: none
};

/// Channels of the logs in order. Throws as log::rawRecord().
std::vector<RawChannels> rawChannels(const std::vector<log::Log>& logs, const std::vector<log::Log>& hold_out);

}  // namespace rubber_suspension::diagnosis::prepare
