// Errors of the rig in each log, from the residual of a judged model.
#pragma once

#include <vector>

#include "gap/simulate.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the errors of the rig in each record, from the residual of `judged`, with intervals that allow for the
/// accepted error of the model. An error is reported only if `rival`, the next likely elements, gives a value within
/// its interval, or if it is one of a single log (gap::OwnErrors).
std::vector<measurement::RigFinding> rigFindings(const std::vector<element::ElementDescription>& judged,
                                                 const std::vector<element::ElementDescription>& rival,
                                                 const io::RigTolerances& tolerances,
                                                 const std::vector<gap::PreparedRecord>& records, int threads);

/// Noise of the amplifier that rises towards low frequencies.
struct ColouredNoise {
  std::vector<measurement::RigFinding> findings;
  std::vector<double> floors;  ///< noise of each record, in units of its force's standard deviation
};

/// Returns the noise of the amplifier in what the judged model leaves if its probability is 0.9 or more; else nothing.
/// Such a part of the residual is noise, not an error of the model, if its power does not follow that of the force.
ColouredNoise colouredNoise(const std::vector<gap::PreparedRecord>& records, const gap::Forces& simulated);

}  // namespace rubber_suspension::diagnosis::results
