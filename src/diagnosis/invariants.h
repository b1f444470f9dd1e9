// Invariants that every report has to satisfy. A report that violates one states no result.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Returns the names of the invariants (docs/diagnosis.md) that a diagnosis breaks.
std::vector<std::string> brokenInvariants(const Diagnosis& diagnosis);

/// Returns the diagnosis unchanged if it breaks no invariant. Otherwise returns it without its results, with
/// Verdict::defect and the names of the broken invariants.
Diagnosis heldToInvariants(Diagnosis diagnosis);

}  // namespace rubber_suspension::diagnosis
