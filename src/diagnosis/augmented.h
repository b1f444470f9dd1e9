// The component that a fitted hypothesis amounts to.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diagnosis/search.h"
#include "fit/model_parameters.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::diagnosis {

/// The entries of a fitted hypothesis as a user would write them: sliders of one friction in one table.
std::vector<element::ElementDescription> entriesOf(const FittedHypothesis& fitted);

/// Headline numbers of an effect for the report; all of them are in its entries.
std::map<std::string, double> headlineOf(const std::vector<element::ElementDescription>& entries);

/// The model with the parameters of a fit and its entries on top.
io::ComponentDescription augmentedDescription(const fit::ModelParameters& model, const FittedHypothesis& fitted);

}  // namespace rubber_suspension::diagnosis
