// Series compliance.
#include "rubber_suspension/element/series_compliance.h"

#include <cmath>

namespace rubber_suspension::element {

double SeriesCompliance::deflection(double force) const {
  if ((side_ == Side::tension && force < 0.0) || (side_ == Side::compression && force > 0.0)) {
    return 0.0;
  }
  const double closure = closing_force_ > 0.0 ? 1.0 + std::abs(force) / closing_force_ : 1.0;
  return force / (stiffness_ * closure);
}

std::optional<SeriesElement::Compliance> SeriesCompliance::compliance() const {
  if (closing_force_ > 0.0) {
    return std::nullopt;
  }
  const double compliance = 1.0 / stiffness_;
  return Compliance{side_ == Side::compression ? 0.0 : compliance, side_ == Side::tension ? 0.0 : compliance};
}

ElementType seriesComplianceType() {
  return {"series_compliance",
          "Compliance of bracket, bolted connection or rig in series with the test piece: u = F/(K_s (1 + |F|/F_c)).",
          {{"stiffness", "N/m", Role::shape, Range::positive(), "stiffness K_s of what is in series"},
           {"closing_force", "N", Role::shape, Range::nonNegative(),
            "force F_c that halves its compliance, as of a bolted connection that closes under load; 0: linear", 0.0},
           {"side", "1", Role::choice, Range::closed(-1.0, 1.0),
            "1: yields to F > 0 only, -1: to F < 0 only, 0: to both", 0.0}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const SeriesCompliance>(
                description.value("stiffness"), description.value("closing_force"),
                static_cast<SeriesCompliance::Side>(sideOf(description, "F")));
          }};
}

}  // namespace rubber_suspension::element
