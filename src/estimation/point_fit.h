// The model that is nearest to measured points of stiffness and loss angle.
#pragma once

#include <vector>

#include "rubber_suspension/estimation/whole.h"

namespace rubber_suspension::estimation {

/// Returns the base with the least sum of weight |d ln K + i d delta|^2 over the points, of the whole component if the
/// specification describes that. A static_stiffness or static_curve, a break_frequency and the band of multi_maxwell
/// are kept where they are given. The numbers of the base are those at nominal_frequency and nominal_amplitude, by
/// default the geometric means of those of the points. Throws std::invalid_argument if the points do not determine the
/// model, or a key is given that is fitted.
Resolved fitPoints(Model model, const Specification& specification,
                   const std::vector<element::ElementDescription>& add);

}  // namespace rubber_suspension::estimation
