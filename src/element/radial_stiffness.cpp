// Spring of two directions across an axis, whose stiffness grows with the distance from the axis.
#include "rubber_suspension/element/radial_stiffness.h"

#include "element/registry.h"

namespace rubber_suspension::element {

bool isRadial(const ElementDescription& element) { return element.type == "radial_stiffness"; }

std::vector<RadialStiffness> radialLaws(const std::vector<ElementDescription>& elements) {
  std::vector<RadialStiffness> laws;
  for (const ElementDescription& element : elements) {
    if (isRadial(element)) {
      laws.push_back(dynamic_cast<const RadialStiffness&>(*parallelLaw(makeElement(element))));
    }
  }
  return laws;
}

void addAcross(const std::vector<RadialStiffness>& laws, const double* displacement, const double* across,
               std::size_t count, double* force) {
  for (const RadialStiffness& law : laws) {
    for (std::size_t i = 0; i < count; ++i) {
      force[i] += law.force(displacement[i], across[i]) - law.force(displacement[i], 0.0);
    }
  }
}

namespace {

const ElementEntry kRadialStiffnessEntry(
    40, {"radial_stiffness",
         "Stiffness that rises with the radius r of two directions across an axis: in each direction F = x (h(r) - (1 "
         "- a) h(|x|)) with h(r) = k2 r + k3 r^2 + k5 r^4; for a single direction r = |x|.",
         {{"quadratic", "N/m^2", Role::scale, Range::nonNegative(),
           "coefficient k2; one of the coefficients must be greater than 0", 0.0},
          {"cubic", "N/m^3", Role::scale, Range::nonNegative(), "coefficient k3", 0.0},
          {"quintic", "N/m^5", Role::scale, Range::nonNegative(), "coefficient k5", 0.0},
          {"alone", "1", Role::choice, Range::closed(0.0, 1.0),
           "share a of the force that remains for motion along only one of the directions", 1.0}},
         [](const ElementDescription& description) -> ElementPointer {
           const double quadratic = description.value("quadratic");
           const double cubic = description.value("cubic");
           const double quintic = description.value("quintic");
           if (quadratic == 0.0 && cubic == 0.0 && quintic == 0.0) {
             refuseValue(description.type, "cubic", cubic, "N/m^3",
                         "at least one of cubic, quadratic and quintic greater than 0");
           }
           return std::make_shared<const RadialStiffness>(quadratic, cubic, quintic, description.value("alone"));
         }});

}  // namespace
}  // namespace rubber_suspension::element
