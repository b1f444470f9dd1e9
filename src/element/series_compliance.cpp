// Series compliance: bracket, rig frame, adapter or bolted connection that yields in series with the test piece.
#include <cmath>

#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// Adds the deflection u = F/(K_s (1 + |F|/F_c)), optionally for one sign of the force only. The component solves for
/// the displacement of the test piece at each step. The deflections of several elements are added.
///
/// Without a closing force F_c, u = F/K_s. Then 1/K*_measured = 1/K* + 1/K_s, which lowers stiffness and loss angle
/// with the same K_s at all frequencies. With F_c, the contact closes under load: the tangent compliance is
/// 1/(K_s (1 + |F|/F_c)^2), the secant compliance is halved at F_c, and the deflection remains below F_c/K_s. A bolted
/// connection that opens in tension, or a pad that is not attached, is a compliance for one sign of the force in series
/// with another for both signs. Source of the closure: Bandis, Lumsden and Barton, Int. J. Rock Mech. Min. Sci. 20
/// (1983) 249-268.
class SeriesCompliance final : public SeriesElement {
 public:
  enum class Side { compression = -1, both = 0, tension = 1 };

  SeriesCompliance(double stiffness /* K_s [N/m] */, double closing_force /* F_c [N], 0: none */, Side side)
      : stiffness_(stiffness), closing_force_(closing_force), side_(side) {}

  double deflection(double force) const override {
    if ((side_ == Side::tension && force < 0.0) || (side_ == Side::compression && force > 0.0)) {
      return 0.0;
    }
    const double closure = closing_force_ > 0.0 ? 1.0 + std::abs(force) / closing_force_ : 1.0;
    return force / (stiffness_ * closure);
  }

  std::optional<Compliance> compliance() const override {
    if (closing_force_ > 0.0) {
      return std::nullopt;
    }
    const double compliance = 1.0 / stiffness_;
    return Compliance{side_ == Side::compression ? 0.0 : compliance, side_ == Side::tension ? 0.0 : compliance};
  }

 private:
  double stiffness_;
  double closing_force_;
  Side side_;
};

const ElementEntry kSeriesComplianceEntry(
    400, {"series_compliance",
          "Compliance of bracket, bolted connection or rig in series with the test piece: u = F/(K_s (1 + |F|/F_c)).",
          {{"stiffness", "N/m", Role::shape, Range::positive(), "stiffness K_s of the parts in series"},
           {"closing_force", "N", Role::shape, Range::nonNegative(),
            "force F_c at which the compliance is halved, as in a bolted joint that closes under load; 0: constant "
            "compliance",
            0.0},
           {"side", "1", Role::choice, Range::closed(-1.0, 1.0),
            "1: compliant for F > 0 only; -1: for F < 0 only; 0: for both", 0.0}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const SeriesCompliance>(
                description.value("stiffness"), description.value("closing_force"),
                static_cast<SeriesCompliance::Side>(sideOf(description, "F")));
          }});

}  // namespace
}  // namespace rubber_suspension::element
