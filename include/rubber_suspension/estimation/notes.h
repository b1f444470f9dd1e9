// Remarks on an estimation: unused inputs, reconstructions, limits.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// Returns one sentence each. Throws std::out_of_range if an input that the model needs is missing.
std::vector<std::string> estimationNotes(Model model, const Specification& specification);

/// Returns the valid but suspicious values of a specification, such as a wrong unit: one sentence each, which begins
/// with the key. Empty for the model `elements`. Throws nothing.
std::vector<std::string> specificationWarnings(const Specification& specification);

}  // namespace rubber_suspension::estimation
