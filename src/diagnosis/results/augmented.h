// The component that a fitted hypothesis amounts to.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/model_parameters.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::diagnosis {

/// The entries of a fitted hypothesis as a user would write them: sliders of one friction in one table.
std::vector<element::ElementDescription> entriesOf(const FittedHypothesis& fitted);

/// One headline number of an effect.
struct HeadlineValue {
  std::string name;
  std::string unit;  ///< SI; "1" for none
  double value = 0.0;
  bool is_scale = false;  ///< the effect is gone at 0
};

/// Headline numbers of an effect, as an engineer says them: what a fit moved, without choices and references. Of all
/// that yields in a friction together the maximum force and the displacement at which half of it is reached from rest,
/// as of the element `friction`; of stops the gap and the stiffness of each side; of what follows the temperature the
/// change of stiffness and of rates per kelvin at the reference; of other entries of one type the sum of the first
/// parameter of their law, as total_NAME.
std::vector<HeadlineValue> headlineValuesOf(const std::vector<element::ElementDescription>& entries);

/// The same by name, as report.json has them.
std::map<std::string, double> headlineOf(const std::vector<element::ElementDescription>& entries);

/// The model with the parameters of a fit and its entries on top.
io::ComponentDescription augmentedDescription(const fit::ModelParameters& model, const FittedHypothesis& fitted);

}  // namespace rubber_suspension::diagnosis
