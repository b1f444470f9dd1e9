// Notes on an estimation: unused inputs, reconstructions, limits.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// Returns the notes, one sentence each. Throws std::out_of_range if an input that the model needs is missing.
std::vector<std::string> estimationNotes(Model model, const Specification& specification);

/// Returns warnings about values that are valid but suspicious, for example because of a wrong unit: one sentence each,
/// which begins with the key. Returns none for the model `elements`. Throws nothing.
std::vector<std::string> specificationWarnings(const Specification& specification);

}  // namespace rubber_suspension::estimation
