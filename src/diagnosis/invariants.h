// Invariants of every report; one that violates them states no result.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Names of the invariants (docs/diagnosis.md) that a diagnosis breaks.
std::vector<std::string> brokenInvariants(const Diagnosis& diagnosis);

/// The diagnosis as it is, or one that breaks an invariant without its verdict: Verdict::defect, and which it breaks.
Diagnosis heldToInvariants(Diagnosis diagnosis);

}  // namespace rubber_suspension::diagnosis
