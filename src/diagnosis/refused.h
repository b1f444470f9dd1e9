// The diagnosis of a measurement that cannot be what it says.
#pragma once

#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Verdict check_bench, by the first finding that is fatal.
Diagnosis refused(const io::ComponentDescription& component, std::vector<measurement::RigFinding> findings);

}  // namespace rubber_suspension::diagnosis
