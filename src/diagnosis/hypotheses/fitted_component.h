// The component of a fitted hypothesis.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/model_parameters.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Returns the entries of a fitted hypothesis as a user would write them, such as all sliders of a friction in one
/// table.
std::vector<element::ElementDescription> entriesOf(const FittedHypothesis& fitted);

/// Returns the model with the parameters of a fitted hypothesis, and adds the entries of that hypothesis.
io::ComponentDescription augmentedDescription(const fit::ModelParameters& model, const FittedHypothesis& fitted);

}  // namespace rubber_suspension::diagnosis::hypotheses
