// Fit of a model to measured points of stiffness and loss angle.
#pragma once

#include <vector>

#include "rubber_suspension/estimation/whole.h"

namespace rubber_suspension::estimation {

/// Returns the base that minimises the sum over all points of weight |d ln K + i d delta|^2, computed for the whole
/// component if the specification describes the component. A given static_stiffness or static_curve, break_frequency
/// and band of multi_maxwell are kept. The numbers of the base refer to nominal_frequency and nominal_amplitude, which
/// default to the geometric means over the points. Throws std::invalid_argument if the points do not determine the
/// model, or if a key that is to be fitted is given.
Resolved fitPoints(Model model, const Specification& specification,
                   const std::vector<element::ElementDescription>& add);

}  // namespace rubber_suspension::estimation
