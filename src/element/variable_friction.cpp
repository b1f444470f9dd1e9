// Friction whose limit varies.
#include "rubber_suspension/element/variable_friction.h"

#include <algorithm>
#include <cmath>

#include "element/dead_band.h"
#include "rubber_suspension/element/structure_state.h"

namespace rubber_suspension::element {
namespace {

enum FrictionSlot { kStretch, kBristleState, kWay };

}  // namespace

double VariableFriction::initialise(double displacement, double* memory) const {
  memory[kStretch] = 0.0;
  memory[kBristleState] = 1.0;
  memory[kWay] = displacement;
  return 0.0;
}

double VariableFriction::relax(double displacement, double* memory) const {
  memory[kStretch] = 0.0;
  memory[kWay] = displacement;
  if (parameters_.build_up_time > 0.0) {
    memory[kBristleState] = 1.0;
  }
  return 0.0;
}

double VariableFriction::step(const Motion& motion, double* memory) const {
  if (parameters_.travel > 0.0) {
    Motion way = motion;
    if (parameters_.dead_band > 0.0) {
      way.increment = followed(motion.displacement, parameters_.dead_band, memory[kWay]) - memory[kWay];
      memory[kWay] += way.increment;
    }
    memory[kBristleState] =
        StructureState(way, parameters_.build_up_time, parameters_.travel).after(memory[kBristleState]);
  }
  double limit = parameters_.yield_displacement * memory[kBristleState];
  if (parameters_.growth_displacement > 0.0) {
    limit *= 1.0 + std::abs(motion.displacement) / parameters_.growth_displacement;
  }
  memory[kStretch] = std::clamp(memory[kStretch] + motion.increment, -limit, limit);
  return parameters_.stiffness * memory[kStretch];
}

ElementType variableFrictionType() {
  return {"variable_friction",
          "Friction behind a contact spring that slides at k y m (1 + |z|/d): grows with displacement, wears with "
          "travel (m), builds up at rest.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k while it sticks"},
           {"yield_displacement", "m", Role::shape, Range::positive(),
            "displacement y at which it slides about zero displacement, unworn"},
           {"growth_displacement", "m", Role::shape, Range::nonNegative(),
            "displacement d at which the limit is twice that at zero; 0: no growth", 0.0},
           {"travel", "m", Role::shape, Range::nonNegative(), "travel s over which it wears by e; 0: no wear", 0.0},
           {"build_up_time", "s", Role::shape, Range::nonNegative(), "time T_b over which it builds up again; 0: never",
            0.0},
           {"dead_band", "m", Role::choice, Range::nonNegative(), kDeadBand, 0.0}},
          makes<VariableFriction, VariableFriction::Parameters>(
              "stiffness", "yield_displacement", "growth_displacement", "travel", "build_up_time", "dead_band")};
}

}  // namespace rubber_suspension::element
