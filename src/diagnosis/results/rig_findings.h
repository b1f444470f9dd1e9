// Finds errors of the rig in each log from the residual of a judged model.
#pragma once

#include <vector>

#include "gap/simulate.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the errors of the rig in each record, from the residual of `judged`, with intervals that allow for the
/// accepted error of the model. `rival` is the next likely model. An error is reported only if the value that `rival`
/// gives is within its interval, or if the error belongs to a single log (gap::OwnErrors).
std::vector<measurement::RigFinding> rigFindings(const std::vector<element::ElementDescription>& judged,
                                                 const std::vector<element::ElementDescription>& rival,
                                                 const io::RigTolerances& tolerances,
                                                 const std::vector<gap::PreparedRecord>& records, int threads);

/// Noise of the amplifier that rises towards low frequencies.
struct ColouredNoise {
  std::vector<measurement::RigFinding> findings;
  std::vector<double> floors;  ///< noise in each record, divided by the standard deviation of the force
};

/// Returns the noise of the amplifier in the residual of the judged model if its probability is at least 0.9; otherwise
/// returns nothing. A part of the residual counts as noise if its power does not follow the power of the force.
ColouredNoise colouredNoise(const std::vector<gap::PreparedRecord>& records, const gap::Forces& simulated);

}  // namespace rubber_suspension::diagnosis::results
