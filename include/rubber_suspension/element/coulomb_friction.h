// Coulomb friction with the elasticity of its contact. Throws nothing: makeElement() checks the values.
#pragma once

#include "rubber_suspension/element/slider_bank.h"

namespace rubber_suspension::element {

/// A single Jenkins slider: sticks as a spring k up to F_max, then slides at F_max; turns at once at a reversal.
/// For k -> infinity it is Coulomb's law. Settled loss per cycle at amplitude A > F_max/k: 4 F_max (A - F_max/k).
/// Source: C. F. Jenkin, Engineering 114 (1922) 603; as an element of rubber models: Sedlaczek et al. (2011).
class CoulombFriction final : public SliderBank {
 public:
  CoulombFriction(double maximum_force /* F_max [N] */, double stiffness /* k [N/m] */)
      : SliderBank({JenkinsSlider{maximum_force / stiffness, stiffness}}) {}
};

ElementType coulombFrictionType();

}  // namespace rubber_suspension::element
