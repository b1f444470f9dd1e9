// The component that a fitted hypothesis amounts to.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/model_parameters.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// The entries of a fitted hypothesis as a user would write them: sliders of one friction in one table.
std::vector<element::ElementDescription> entriesOf(const FittedHypothesis& fitted);

/// The model with the parameters of a fit and its entries on top.
io::ComponentDescription augmentedDescription(const fit::ModelParameters& model, const FittedHypothesis& fitted);

}  // namespace rubber_suspension::diagnosis::hypotheses
