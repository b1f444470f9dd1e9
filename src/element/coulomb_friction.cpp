// Coulomb friction with the elasticity of its contact.
#include "rubber_suspension/element/coulomb_friction.h"

namespace rubber_suspension::element {

ElementType coulombFrictionType() {
  return {"coulomb_friction",
          "Coulomb friction behind a contact spring: sticks up to its maximum force, then slides.",
          {{"maximum_force", "N", Role::shape, Range::positive(), "force F_max at which it slides"},
           {"stiffness", "N/m", Role::shape, Range::positive(), "stiffness k while it sticks"}},
          makes<CoulombFriction>("maximum_force", "stiffness")};
}

}  // namespace rubber_suspension::element
