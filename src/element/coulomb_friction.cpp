// Coulomb friction with the elasticity of its contact.
#include "element/registry.h"
#include "rubber_suspension/element/slider_bank.h"

namespace rubber_suspension::element {
namespace {

/// A single Jenkins slider: it acts as a spring k up to F_max, then slides at F_max, and sticks again at every
/// reversal. As k tends to infinity it becomes Coulomb's law. The settled loss per cycle at an amplitude A > F_max/k is
/// 4 F_max (A - F_max/k). Source: C. F. Jenkin, Engineering 114 (1922) 603; as an element of rubber models: Sedlaczek
/// et al. (2011).
const ElementEntry kCoulombFrictionEntry(
    250, {"coulomb_friction",
          "Coulomb friction behind a contact spring: the friction sticks up to its maximum force, then slides.",
          {{"maximum_force", "N", Role::shape, Range::positive(), "force F_max at which the friction slides"},
           {"stiffness", "N/m", Role::shape, Range::positive(), "stiffness k while the friction sticks"}},
          [](const ElementDescription& description) -> ElementPointer {
            const double stiffness = description.value("stiffness");
            return std::make_shared<const SliderBank>(
                std::vector<JenkinsSlider>{{description.value("maximum_force") / stiffness, stiffness}});
          }});

}  // namespace
}  // namespace rubber_suspension::element
