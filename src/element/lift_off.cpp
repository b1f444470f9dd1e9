// Contact that opens: a chevron, strap or spring that is not glued to the plate, or one that a preload holds.
#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// In series with the test piece. While the contact is closed it transmits the force unchanged. It opens where its own
/// force would change sign. That is s F + P with the side s and a preload P, as force and displacement are often
/// measured from the preloaded state: then the test piece is free, F = -s P, and recovers by itself; its displacement
/// is the root of this at each step. The contact closes where the plate reaches the length that the test piece then
/// has. A bolt or a guide may hold an open contact: F = -s P + k_s u with the opening u.
///
/// Memory: none, the free length is that of the test piece. Passive on a passive test piece: the work of the contact is
/// that on k_s and on the constant P, both of which return it when the contact closes. Validity: no adhesion, no impact
/// of masses where contact returns, and a preload that stays constant. With k_s it is a series compliance of one side.
/// Source: the Signorini condition; P. Wriggers, Computational Contact Mechanics, 2nd ed., Springer 2006, chapter 2.
class LiftOff final : public SeriesElement {
 public:
  enum class Carries { compression = -1, tension = 1 };

  LiftOff(Carries carries, double slack_stiffness /* k_s [N/m], 0: nothing holds it */, double preload /* P [N] */)
      : carries_(carries), slack_stiffness_(slack_stiffness), preload_(preload) {}

  /// Undefined for an open contact without a holder, which may be anywhere.
  double deflection(double force) const override {
    const double of_contact = force + static_cast<double>(carries_) * preload_;
    const bool opens = carries_ == Carries::tension ? of_contact < 0.0 : of_contact > 0.0;
    return opens ? of_contact / slack_stiffness_ : 0.0;
  }

  /// Infinite for the sign of force that opens a contact without a holder.
  std::optional<Compliance> compliance() const override {
    if (slack_stiffness_ > 0.0 && preload_ > 0.0) {
      return std::nullopt;
    }
    const double open = 1.0 / slack_stiffness_;
    return carries_ == Carries::tension ? Compliance{0.0, open, preload_} : Compliance{open, 0.0, preload_};
  }

 private:
  Carries carries_;
  double slack_stiffness_;
  double preload_;
};

const ElementEntry kLiftOffEntry(
    410,
    {"lift_off",
     "Contact that carries only one sign of force, such as a chevron, strap or spring that is not bonded to its plate: "
     "while the contact is open, the test piece recovers, with no force or that of the preload.",
     {{"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: carries only F > -P; -1: carries only F < P"},
      {"slack_stiffness", "N/m", Role::shape, Range::nonNegative(),
       "stiffness k_s in parallel with the open contact; 0: none", 0.0},
      {"preload", "N", Role::shape, Range::nonNegative(),
       "preload P of the contact at zero measured force: it opens at a force P of the opposite sign", 0.0}},
     [](const ElementDescription& description) -> ElementPointer {
       return std::make_shared<const LiftOff>(static_cast<LiftOff::Carries>(sideOf(description, "F", false)),
                                              description.value("slack_stiffness"), description.value("preload"));
     }});

}  // namespace
}  // namespace rubber_suspension::element
