// Contact that carries one sign of force: a chevron, strap or spring that is not glued to the plate.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// In series with the test piece. It is closed while the force of the test piece has the sign that the contact carries,
/// and does nothing. It opens where the force would turn: then the test piece is free, F = 0, and recovers by itself;
/// its displacement is the root of that at each step. Contact returns where the plate meets it at the length that it
/// has by then. Something else may hold an open contact, a bolt or a guide: F = k_s u with the opening u.
///
/// Memory: none, the free length is that of the test piece. Passive on a passive test piece: the contact does no work,
/// as force or opening is zero; k_s is a spring. Validity: no adhesion, no impact of masses where contact returns. With
/// k_s it is a series compliance of one side. Source: the Signorini condition; P. Wriggers, Computational Contact
/// Mechanics, 2nd ed., Springer 2006, chapter 2. make() throws for a side other than -1 or 1.
class LiftOff final : public SeriesElement {
 public:
  enum class Carries { compression = -1, tension = 1 };

  explicit LiftOff(Carries carries, double slack_stiffness = 0.0 /* k_s [N/m], 0: nothing holds it */)
      : carries_(carries), slack_stiffness_(slack_stiffness) {}

  /// Not of an open contact that nothing holds, which may be anywhere.
  double deflection(double force) const override;

  /// Infinite for the sign of force that opens a contact that nothing holds.
  std::optional<Compliance> compliance() const override;

 private:
  Carries carries_;
  double slack_stiffness_;
};

ElementType liftOffType();

}  // namespace rubber_suspension::element
