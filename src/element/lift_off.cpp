// Contact that opens: a chevron, strap or spring that is not bonded to its plate, or is held there by a preload alone.
#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// A contact in series with the test piece. While closed, it transmits the force unchanged. The force of the contact is
/// s F + P with the side s and a preload P, since force and displacement are often measured from the preloaded state.
/// The contact opens when this force would change sign. While it is open, the test piece is free, F = -s P, and
/// recovers; each step solves this equation for the displacement of the test piece. The contact closes when the plate
/// reaches the present length of the test piece. If a bolt or a guide bridges the open contact, F = -s P + k_s u with
/// the opening u.
///
/// The contact has no memory, since the state of the test piece determines its free length. With a passive test piece
/// the law is passive, since k_s and the constant P return the work of opening when the contact closes. Validity: no
/// adhesion, no impact of masses when the contact closes, and a constant preload. With k_s the contact is a series
/// compliance of one side. Source: the Signorini condition; P. Wriggers, Computational Contact Mechanics, 2nd ed.,
/// Springer 2006, chapter 2.
class LiftOff final : public SeriesElement {
 public:
  enum class Carries { compression = -1, tension = 1 };

  LiftOff(Carries carries, double slack_stiffness /* k_s [N/m], 0: none */, double preload /* P [N] */)
      : carries_(carries), slack_stiffness_(slack_stiffness), preload_(preload) {}

  /// Returns infinity for an open contact without k_s, whose opening is arbitrary.
  double deflection(double force) const override {
    const double of_contact = force + static_cast<double>(carries_) * preload_;
    const bool opens = carries_ == Carries::tension ? of_contact < 0.0 : of_contact > 0.0;
    return opens ? of_contact / slack_stiffness_ : 0.0;
  }

  /// Returns an infinite compliance for the sign of the force that opens a contact without k_s.
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
     "while the contact is open, the test piece recovers, and the force is 0 or stays at the preload.",
     {{"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: carries only F > -P; -1: carries only F < P"},
      {"slack_stiffness", "N/m", Role::shape, Range::nonNegative(),
       "stiffness k_s in parallel with the open contact; 0: none", 0.0},
      {"preload", "N", Role::shape, Range::nonNegative(),
       "preload P of the contact at zero measured force: the contact opens at a force P of the opposite sign", 0.0}},
     [](const ElementDescription& description) -> ElementPointer {
       return std::make_shared<const LiftOff>(static_cast<LiftOff::Carries>(sideOf(description, "F", false)),
                                              description.value("slack_stiffness"), description.value("preload"));
     }});

}  // namespace
}  // namespace rubber_suspension::element
