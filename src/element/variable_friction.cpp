// Friction whose limit varies.
#include "rubber_suspension/element/variable_friction.h"

#include <algorithm>
#include <cmath>

#include "rubber_suspension/element/structure_state.h"

namespace rubber_suspension::element {
namespace {

enum FrictionSlot { kStretch, kBristleState };

}  // namespace

double VariableFriction::initialise(double /*displacement*/, double* memory) const {
  memory[kStretch] = 0.0;
  memory[kBristleState] = 1.0;
  return 0.0;
}

double VariableFriction::relax(double /*displacement*/, double* memory) const {
  memory[kStretch] = 0.0;
  if (parameters_.build_up_time > 0.0) {
    memory[kBristleState] = 1.0;
  }
  return 0.0;
}

double VariableFriction::step(const Motion& motion, double* memory) const {
  if (parameters_.travel > 0.0) {
    memory[kBristleState] =
        StructureState(motion, parameters_.build_up_time, parameters_.travel).after(memory[kBristleState]);
  }
  double limit = parameters_.yield_displacement * memory[kBristleState];
  if (parameters_.growth_displacement > 0.0) {
    limit *= 1.0 + std::abs(motion.displacement) / parameters_.growth_displacement;
  }
  memory[kStretch] = std::clamp(memory[kStretch] + motion.increment, -limit, limit);
  return parameters_.stiffness * memory[kStretch];
}

ElementType variableFrictionType() {
  return {
      "variable_friction",
      "Friction behind a contact spring that slides at k y m (1 + |z|/d): grows with displacement, wears with "
      "travel (m), builds up at rest.",
      {{"stiffness", "N/m", Role::scale, Range::positive(), std::nullopt, "stiffness k while it sticks"},
       {"yield_displacement", "m", Role::shape, Range::positive(), std::nullopt,
        "displacement y at which it slides about zero displacement, unworn"},
       {"growth_displacement", "m", Role::shape, Range::nonNegative(), 0.0,
        "displacement d at which the limit is twice that at zero; 0: no growth"},
       {"travel", "m", Role::shape, Range::nonNegative(), 0.0, "travel s over which it wears by e; 0: no wear"},
       {"build_up_time", "s", Role::shape, Range::nonNegative(), 0.0,
        "time T_b over which it builds up again; 0: never"}},
      [](const ElementDescription& description) -> ElementPointer {
        return std::make_shared<const VariableFriction>(VariableFriction::Parameters{
            description.value("stiffness"), description.value("yield_displacement"),
            description.value("growth_displacement"), description.value("travel"), description.value("build_up_time")});
      }};
}

}  // namespace rubber_suspension::element
