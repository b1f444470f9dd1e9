// The static curve of a component, in place of its static stiffness.
#pragma once

#include <vector>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::estimation {

/// Points of force over displacement, linear between them, with the end slopes beyond. Displacement and force are
/// absolute: those of topics and logs.
struct StaticCurve {
  std::vector<double> displacement;  ///< increasing [m]
  std::vector<double> force;         ///< [N]
  bool monotone = false;             ///< falling forces are refused
  bool scales = true;  ///< Maxwell elements and dashpots scale with the slope of the curve at each displacement

  /// Throws std::invalid_argument that begins with "static_curve" for lists that are no curve, for a slope that is
  /// negative with `monotone`, and for one that is not positive with `scales`.
  void check() const;

  double forceAt(double displacement) const;  ///< [N]

  /// Returns the slope [N/m]; at a point of the curve the mean of both sides.
  double tangentAt(double displacement) const;

  /// Returns the displacement [m] of a force [N]. Throws std::invalid_argument if there is none, or more than one.
  double displacementAt(double force) const;

  /// Returns the slope of each piece [N/m].
  std::vector<double> slopes() const;
};

/// Returns an element whose stiffness, damping or sliders follow the slope of the curve, relative to that at the
/// working point [m]: Maxwell element, dashpot, bank of sliders. Throws std::invalid_argument for any other.
element::ElementDescription scaledAlong(const StaticCurve& curve, double nominal_displacement,
                                        const element::ElementDescription& entry);

}  // namespace rubber_suspension::estimation
