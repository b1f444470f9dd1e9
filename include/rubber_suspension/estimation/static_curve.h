// The static curve of a component, which replaces its static stiffness.
#pragma once

#include <vector>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::estimation {

/// Points of force over displacement, interpolated linearly and extrapolated with the slopes at the ends. Displacement
/// and force are absolute, as in topics and logs.
struct StaticCurve {
  std::vector<double> displacement;  ///< increasing values [m]
  std::vector<double> force;         ///< [N]
  bool monotone = false;             ///< true if a decreasing force is rejected
  bool scales = true;  ///< true if Maxwell elements and dashpots scale with the slope of the curve at each displacement

  /// Throws std::invalid_argument that begins with "static_curve" if the lists are no curve, if a slope is negative
  /// although `monotone`, or if a slope is not positive although `scales`.
  void check() const;

  double forceAt(double displacement) const;  ///< [N]

  /// Returns the slope [N/m]. At a point of the curve it is the mean of the slopes on both sides.
  double tangentAt(double displacement) const;

  /// Returns the displacement [m] for a force [N]. Throws std::invalid_argument if there are none or several.
  double displacementAt(double force) const;

  /// Returns the slope between each two neighbouring points [N/m].
  std::vector<double> slopes() const;
};

/// Returns an element that scales with the slope of the curve relative to that at the working point [m]. Throws
/// std::invalid_argument for elements other than a Maxwell element, a dashpot and a bank of sliders.
element::ElementDescription scaledAlong(const StaticCurve& curve, double nominal_displacement,
                                        const element::ElementDescription& entry);

}  // namespace rubber_suspension::estimation
