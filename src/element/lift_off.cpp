// Contact that carries one sign of force.
#include "rubber_suspension/element/lift_off.h"

namespace rubber_suspension::element {

double LiftOff::deflection(double force) const {
  const bool opens = carries_ == Carries::tension ? force < 0.0 : force > 0.0;
  return opens ? force / slack_stiffness_ : 0.0;
}

std::optional<SeriesElement::Compliance> LiftOff::compliance() const {
  const double open = 1.0 / slack_stiffness_;
  return carries_ == Carries::tension ? Compliance{0.0, open} : Compliance{open, 0.0};
}

ElementType liftOffType() {
  return {"lift_off",
          "Contact that carries one sign of force, as of a chevron, strap or spring that is not glued to the plate: "
          "slack, the test piece has no force and recovers.",
          {{"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: carries F > 0 only, -1: F < 0 only"},
           {"slack_stiffness", "N/m", Role::shape, Range::nonNegative(),
            "stiffness k_s of what holds an open contact; 0: nothing", 0.0}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const LiftOff>(static_cast<LiftOff::Carries>(sideOf(description, "F", false)),
                                                   description.value("slack_stiffness"));
          }};
}

}  // namespace rubber_suspension::element
