// A log prepared for fits: samples that do not count, and a start in motion.
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
  log::Record record;                ///< with `counts` if some samples do not count
  std::vector<RigFinding> findings;  ///< spikes, held values, saturation
};

/// Prepares a log; `lead_in`: the motion before it. Samples that a channel did not measure are bridged and do not
/// count, nor does the first cycle of a log that starts in motion, because friction depends on the motion before. A log
/// with a constant channel gives the raw record, for checkBench() to report. Throws LogError as makeRecord() does, and
/// if fewer than half of the samples count.
PreparedLog prepareLog(const log::Log& log, log::LeadIn lead_in = {});

/// Prepares a piece of a longer log, before which the component is simulated, so that its first cycle counts.
PreparedLog preparePiece(const log::Log& log);

/// Returns orthonormal columns, per record, of the forces that a motion before it may have caused: relaxing ones if the
/// log starts in motion, and those after typical motions, mainly by friction. A tolerance of 0 excludes them.
/// `simulated`: force of the component over the records [N]; `simulate`: over other displacements.
std::vector<Eigen::MatrixXd> initialStates(const std::vector<gap::PreparedRecord>& records,
                                           const io::RigTolerances& tolerances,
                                           const std::vector<Eigen::VectorXd>& simulated, const Simulate& simulate);

}  // namespace rubber_suspension::measurement
