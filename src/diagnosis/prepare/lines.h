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
  std::vector<Eigen::VectorXd> forces;  ///< sum of the lines of each log [N]; empty if it has none
};

/// Finds the lines of the rig in the residual: oscillations at one frequency and of steady amplitude, in every log that
/// could show them. A log cannot show a line
///   - at a frequency of its displacement, a multiple of one, or an alias of a multiple, because friction and stops
///     cause lines there; nor any line if its displacement has steady frequencies that are no multiples of the lowest;
///   - of less than three times the amplitude of the residual beside it, or beyond the spectrum.
/// The prior probability of a line is 1 %, spread evenly over all frequencies. Of two lines closer than six frequency
/// steps of a block's spectrum, only the larger one is found.
RigLines linesOfRig(const std::vector<log::Record>& records, const gap::Forces& simulated);

}  // namespace rubber_suspension::diagnosis::prepare
