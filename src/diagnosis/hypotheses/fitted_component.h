// Converts a fitted hypothesis to a component description.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/model_parameters.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Returns the entries of a fitted hypothesis as a user would write them, with all sliders of a friction in one table.
std::vector<element::ElementDescription> entriesOf(const FittedHypothesis& fitted);

/// Returns a component with the model parameters and the additional entries of a fitted hypothesis.
io::ComponentDescription augmentedDescription(const fit::ModelParameters& model, const FittedHypothesis& fitted);

}  // namespace rubber_suspension::diagnosis::hypotheses
