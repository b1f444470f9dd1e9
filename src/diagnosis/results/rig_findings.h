// The faults of the rig in each log, by what a judged model leaves of it.
#pragma once

#include <vector>

#include "gap/simulate.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::results {

/// The faults of the rig in each record, by what `judged` leaves of it: the values that the priors and the accepted
/// error allow, each with the uncertainty that the accepted error leaves it. Not told where `rival`, the next likely
/// elements, gives a value outside of its interval, but for what a log has for itself (gap::OwnErrors).
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
