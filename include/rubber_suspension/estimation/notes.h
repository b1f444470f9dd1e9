// Remarks on an estimation beside its numbers: inputs unused, reconstructions, limits.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// One sentence each. Throws std::out_of_range where an input that the model needs is missing.
std::vector<std::string> estimationNotes(Model model, const Specification& specification);

/// Valid but suspicious values of a specification, such as a wrong unit: one sentence each, which begins with the key.
/// Empty for the model `elements`. Throws nothing.
std::vector<std::string> specificationWarnings(const Specification& specification);

}  // namespace rubber_suspension::estimation
