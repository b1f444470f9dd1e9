// From a specification of a whole component, or of measured points, to the numbers of its base.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// A point of a fit and the misfit of the component.
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

/// The base of a component with elements that are added. A specification of a base comes back as it is.
///
/// describes: component: the numbers for which the model, its static curve and what is added have K_n, the loss angle
/// and the high-frequency stiffness asked for on the settled loop at (f_n, A_n) about the nominal displacement (Eqs. 1
/// and 2), to 1e-9. K_st and K_max are those of the linear part and of the curve, with the springs and Maxwell elements
/// that are added and without friction. Effects that never settle (drift, heating, softening) are ignored and named in
/// the notes.
///
/// points: those with the least sum of weight |d ln K + i d delta|^2 over the points.
///
/// Throws std::invalid_argument that names key, value and the interval that it could take, where there is no solution.
Resolved resolve(Model model, const Specification& specification, const std::vector<element::ElementDescription>& add);

}  // namespace rubber_suspension::estimation
