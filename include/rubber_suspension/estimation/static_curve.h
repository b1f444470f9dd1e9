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

  /// Throws std::invalid_argument that begins with "static_curve" on lists that are no curve, and on a slope that is
  /// not positive where monotone or scales asks for that.
  void check() const;

  double forceAt(double displacement) const;  ///< [N]

  /// Slope [N/m]; at a point of the curve the mean of both sides.
  double tangentAt(double displacement) const;

  /// Displacement [m] of a force [N]. Throws std::invalid_argument where there is none, or more than one.
  double displacementAt(double force) const;

  /// Slope of each piece [N/m].
  std::vector<double> slopes() const;
};

/// An element whose stiffness, damping or sliders follow the slope of the curve, relative to that at the working point
/// [m]: Maxwell element, dashpot, bank of sliders. Throws std::invalid_argument for any other.
element::ElementDescription scaledAlong(const StaticCurve& curve, double nominal_displacement,
                                        const element::ElementDescription& entry);

}  // namespace rubber_suspension::estimation
