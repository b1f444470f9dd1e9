// Finds the spectral lines that mains or a pump add to the force of all logs.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gap/simulate.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::prepare {

struct RigLines {
  std::vector<measurement::RigFinding> findings;
  std::vector<Eigen::VectorXd> forces;  ///< sum of all lines in each log [N]; empty for a log without lines
};

/// Finds the lines of the rig in the residual. A line of the rig is an oscillation of fixed frequency and steady
/// amplitude that appears in every log that could show it. A log cannot show a line
///   - at a frequency of its displacement, at a multiple of such a frequency or at an alias of a multiple, because
///     friction and stops cause lines there; it can show no line at all if its displacement has steady frequencies that
///     are not multiples of the lowest;
///   - if the amplitude of the line is less than three times that of the residual at neighbouring frequencies, or if
///     the frequency is outside the spectrum.
/// The prior probability of a line is 1 %, spread evenly over all frequencies. If two lines are closer than six
/// frequency steps of the spectrum of a block, only the larger line is found.
RigLines linesOfRig(const std::vector<log::Record>& records, const gap::Forces& simulated);

}  // namespace rubber_suspension::diagnosis::prepare
