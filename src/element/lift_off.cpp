// Contact that carries one sign of force: a chevron, strap or spring that is not glued to the plate.
#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// In series with the test piece. While the contact is closed it transmits the force unchanged. It opens where the
/// force would change sign: then the test piece is free, F = 0, and recovers by itself; its displacement is the root of
/// this at each step. The contact closes where the plate reaches the length that the test piece then has. A bolt or a
/// guide may hold an open contact: F = k_s u with the opening u.
///
/// Memory: none, the free length is that of the test piece. Passive on a passive test piece: the contact does no work,
/// as force or opening is zero; k_s is a spring. Validity: no adhesion, no impact of masses where contact returns. With
/// k_s it is a series compliance of one side. Source: the Signorini condition; P. Wriggers, Computational Contact
/// Mechanics, 2nd ed., Springer 2006, chapter 2.
class LiftOff final : public SeriesElement {
 public:
  enum class Carries { compression = -1, tension = 1 };

  LiftOff(Carries carries, double slack_stiffness /* k_s [N/m], 0: nothing holds it */)
      : carries_(carries), slack_stiffness_(slack_stiffness) {}

  /// Undefined for an open contact without a holder, which may be anywhere.
  double deflection(double force) const override {
    const bool opens = carries_ == Carries::tension ? force < 0.0 : force > 0.0;
    return opens ? force / slack_stiffness_ : 0.0;
  }

  /// Infinite for the sign of force that opens a contact without a holder.
  std::optional<Compliance> compliance() const override {
    const double open = 1.0 / slack_stiffness_;
    return carries_ == Carries::tension ? Compliance{0.0, open} : Compliance{open, 0.0};
  }

 private:
  Carries carries_;
  double slack_stiffness_;
};

const ElementEntry kLiftOffEntry(
    410, {"lift_off",
          "Contact that carries one sign of force, as of a chevron, strap or spring that is not glued to the plate: "
          "slack, the test piece has no force and recovers.",
          {{"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: carries F > 0 only, -1: F < 0 only"},
           {"slack_stiffness", "N/m", Role::shape, Range::nonNegative(),
            "stiffness k_s of what holds an open contact; 0: nothing", 0.0}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const LiftOff>(static_cast<LiftOff::Carries>(sideOf(description, "F", false)),
                                                   description.value("slack_stiffness"));
          }});

}  // namespace
}  // namespace rubber_suspension::element
