// A log made ready for fits with what its rig did to it: samples that do not count, zeros, a start in motion.
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
  log::Record record;                ///< with `counts` where samples do not count
  std::vector<RigFinding> findings;  ///< spikes, held values, saturation
};

/// Makes a log, to which a motion led, ready: samples that a channel did not measure are bridged and do not count, nor
/// does the first cycle of a log that starts in motion, in which friction remembers what came before. The record of a
/// log with a constant channel is raw: checkBench() reports it. Throws LogError as makeRecord() does, and where fewer
/// than half of the samples are left.
PreparedLog prepareLog(const log::Log& log, log::LeadIn lead_in = {});

/// Prepares a piece of a longer log, which the component has moved through: its first cycle counts.
PreparedLog preparePiece(const log::Log& log);

/// Orthonormal columns of what a motion before each record may have left in a component: where the log starts in
/// motion, what decays, and what motions before it would have left (in its friction, above all). A tolerance of 0 takes
/// them out. `simulated`: force of that component over the records [N]; `simulate`: over other displacements.
std::vector<Eigen::MatrixXd> initialStates(const std::vector<gap::PreparedRecord>& records,
                                           const io::RigTolerances& tolerances,
                                           const std::vector<Eigen::VectorXd>& simulated, const Simulate& simulate);

}  // namespace rubber_suspension::measurement
