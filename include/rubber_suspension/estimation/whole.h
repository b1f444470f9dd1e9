// From a specification of a whole component, or of measured points, to the numbers of its base.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// A point of a fit, with stiffness and loss angle of the fitted component.
struct PointMisfit {
  SpecifiedPoint point;
  double stiffness = 0.0;   ///< of the component there [N/m]
  double loss_angle = 0.0;  ///< [rad]
};

struct Resolved {
  Specification specification;  ///< of the base: estimate() gives the elements of the model
  std::vector<std::string> notes;
  std::vector<PointMisfit> points;  ///< of a fit, one for each point
};

/// Returns the base of a component with added elements. A specification of a base is returned unchanged.
///
/// `describes: component`: the numbers with which the model, its static curve and the added elements have K_n, the loss
/// angle and the high-frequency stiffness on the settled loop at (f_n, A_n) about the nominal displacement (Eqs. 1 and
/// 2), to about 1e-9. K_st and K_max are those of the linear part and of the curve, with the added springs and Maxwell
/// elements and without friction. Effects that never settle (drift, heating, softening) are ignored and named in the
/// notes.
///
/// `points`: the numbers with the least sum of weight |d ln K + i d delta|^2 over the points.
///
/// Throws std::invalid_argument that names key, value and the interval with solutions if there is no solution.
Resolved resolve(Model model, const Specification& specification, const std::vector<element::ElementDescription>& add);

}  // namespace rubber_suspension::estimation
