// Prepares logs for fits: marks samples that do not count, and handles a start in motion.
#pragma once

#include <vector>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/rig_finding.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::measurement {

/// A record and the findings on single samples of its log.
struct PreparedLog {
  log::Record record;                ///< Record::counts is set if some samples do not count
  std::vector<RigFinding> findings;  ///< spikes, held values, saturation
};

/// Prepares a log. `lead_in`: the motion before the log. Samples that a channel did not measure are interpolated and do
/// not count. The first cycle of a log that starts in motion does not count either, because friction depends on earlier
/// motion. A log with a constant channel is returned unchanged, so that checkBench() reports it. Throws LogError like
/// makeRecord(), and if fewer than half of the samples count.
PreparedLog prepareLog(const log::Log& log, log::LeadIn lead_in = {});

/// Prepares a piece of a longer log. Its first cycle counts, because the log before the piece is simulated, too.
PreparedLog preparePiece(const log::Log& log);

/// Returns an orthonormal basis, per record, of the forces that an earlier motion may have caused: relaxing forces if
/// the log starts in motion, and forces after typical motions, mainly due to friction. A tolerance of 0 excludes them.
/// `simulated`: force of the component over the records [N]; `simulate`: simulates other displacements.
std::vector<Eigen::MatrixXd> initialStates(const std::vector<gap::PreparedRecord>& records,
                                           const io::RigTolerances& tolerances,
                                           const std::vector<Eigen::VectorXd>& simulated, const Simulate& simulate);

}  // namespace rubber_suspension::measurement
