// Finds the numbers of the base (the model without added elements) for a specification of a component, or for points.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::estimation {

/// A point to which a model was fitted, with stiffness and loss angle of the fitted component.
struct PointMisfit {
  SpecifiedPoint point;
  double stiffness = 0.0;   ///< stiffness of the fitted component at the point [N/m]
  double loss_angle = 0.0;  ///< loss angle of the fitted component at the point [rad]
};

struct Resolved {
  Specification specification;  ///< specification of the base, whose elements estimate() returns
  std::vector<std::string> notes;
  std::vector<PointMisfit> points;  ///< all points of a fit; empty without a fit
};

/// Returns the specification of the base of a component with the elements `add`. A base is returned unchanged.
///
/// If the specification describes the component, the model, its static curve and the added elements together meet
/// dynamic_stiffness, loss_angle and high_frequency_stiffness. These are defined on the settled loop at nominal
/// frequency and amplitude about the nominal displacement (Eqs. 1 and 2 of Polach, IAVSD 2015), and met to about 1e-9.
/// static_stiffness and maximum_stiffness refer to the curve and the linear part, including added springs and Maxwell
/// elements but no friction. Effects that never settle (drift, heating, softening) are ignored, as a note states.
///
/// If points are given, the numbers minimise the sum over all points of weight |d ln K + i d delta|^2.
///
/// Throws std::invalid_argument that states key, value and the interval with solutions if there is no solution.
Resolved resolve(Model model, const Specification& specification, const std::vector<element::ElementDescription>& add);

}  // namespace rubber_suspension::estimation
