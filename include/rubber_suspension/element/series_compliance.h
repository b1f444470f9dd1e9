// Series compliance: bracket, rig frame, adapter or bolted connection that yields in series with the test piece.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Deflection u = F/(K_s (1 + |F|/F_c)), towards one side alone if so asked. The component solves for the displacement
/// of the test piece at each step. Several add their deflections. make() throws for a side other than -1, 0 or 1.
///
/// Without a closing force u = F/K_s: 1/K*_measured = 1/K* + 1/K_s lowers stiffness and loss angle, alike at all
/// frequencies. With one, contact closes under load: tangent compliance 1/(K_s (1 + |F|/F_c)^2), half the secant
/// compliance at F_c, no more closure than F_c/K_s. A bolted connection, which opens towards tension, or a pad
/// that is not held is a compliance of one side beside one of both.
/// Source of the closure: Bandis, Lumsden and Barton, Int. J. Rock Mech. Min. Sci. 20 (1983) 249-268.
class SeriesCompliance final : public SeriesElement {
 public:
  enum class Side { compression = -1, both = 0, tension = 1 };

  explicit SeriesCompliance(double stiffness /* K_s [N/m] */, double closing_force = 0.0 /* F_c [N], 0: none */,
                            Side side = Side::both)
      : stiffness_(stiffness), closing_force_(closing_force), side_(side) {}

  double deflection(double force) const override;
  std::optional<Compliance> compliance() const override;

 private:
  double stiffness_;
  double closing_force_;
  Side side_;
};

ElementType seriesComplianceType();

}  // namespace rubber_suspension::element
