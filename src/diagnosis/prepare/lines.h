// Lines that mains or a pump add to the force of all logs.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gap/simulate.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::prepare {

/// Lines of a set of logs.
struct RigLines {
  std::vector<measurement::RigFinding> findings;
  std::vector<Eigen::VectorXd> forces;  ///< of all lines of each log [N]; empty where it has none
};

/// Finds the lines in the difference to the simulated force that are the rig's: oscillations at one frequency and of
/// steady amplitude, in every log that could show them. A log could not show a line
///   - at a multiple, or an alias of a multiple, of a steady frequency of its displacement, because friction and stops
///     cause these, or beside several such frequencies;
///   - where the residual beside the line is as large, or beyond the spectrum.
/// The prior probability of a line is 1 %, spread evenly over all frequencies. Of lines closer than six frequencies of
/// a block's spectrum, the larger one is found.
RigLines linesOfRig(const std::vector<log::Record>& records, const gap::Forces& simulated);

}  // namespace rubber_suspension::diagnosis::prepare
