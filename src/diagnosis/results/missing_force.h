// Map of the force that a model lacks, over displacement and velocity.
#pragma once

#include <vector>

#include "gap/simulate.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::diagnosis::results {

/// Of records and the forces on each of them of the augmented component, and of that with a surrogate [N]. Samples that
/// did not count in the fit do not count here.
MissingForce missingForce(const std::vector<log::Record>& records, const gap::Forces& augmented,
                          const gap::Forces& surrogate);

}  // namespace rubber_suspension::diagnosis::results
