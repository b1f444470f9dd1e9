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

/// The lines of the force beside the simulated one that are the rig's: at one frequency, of steady amplitude, in every
/// log that could show them. A log cannot where the frequency is a multiple of one that its displacement holds, or an
/// alias of a multiple, since friction and stops make these; where the displacement holds several frequencies; where
/// its residual is as large beside the line; and beyond its spectrum. All frequencies are equally likely, and a line at
/// any of them has a probability of 1 %.
RigLines linesOfRig(const std::vector<log::Record>& records, const gap::Forces& simulated);

}  // namespace rubber_suspension::diagnosis::prepare
