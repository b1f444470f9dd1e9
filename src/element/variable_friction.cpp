// Friction whose limit grows with displacement, wears with travel, and builds up again at rest.
#include <algorithm>
#include <cmath>

#include "element/dead_band.h"
#include "element/registry.h"
#include "element/structure_state.h"

namespace rubber_suspension::element {
namespace {

enum FrictionSlot { kStretch, kBristleState, kWay };

/// Simulates a Jenkins slider: a spring k in series with a slider that slides at the force k y m (1 + |z|/d).
///
/// With a displacement d the limit grows with the displacement, as in a seat whose pressure rises with its travel, so
/// the loss grows faster than the amplitude. With a travel s the state m wears with the distance, dm/dt = -m |dz/dt|/s.
/// With a build-up time T_b it also recovers, dm/dt = (1 - m)/T_b - m |dz/dt|/s (thixotropy: the friction falls with
/// the rate). Without d, s and T_b it is Coulomb's friction behind a contact spring.
///
/// The force is linear in k for given other parameters. The limit of the force varies, but the stiffness is constant,
/// so the law dissipates for any motion. m is exact for a displacement that is linear over the step, at whose end the
/// limit is evaluated. With a dead band, the distance is measured behind play of this width, so that noise within the
/// play causes no wear. Validity: one rate of wear and one of build-up. Memory: the stretch of the spring [m], m, and
/// the displacement behind the play [m]. A long rest sets m to 1 unless T_b is 0, for which wear is permanent. Source:
/// C. F. Jenkin, Engineering 114 (1922) 603; the state of a structure that motion breaks down: P. Haupt, K. Sedlan,
/// Arch. Appl. Mech. 71 (2001) 89-109; P. Hofer, A. Lion, J. Mech. Phys. Solids 57 (2009) 500-520.
class VariableFriction final : public ParallelElement {
 public:
  struct Parameters {
    double stiffness;            ///< k [N/m]
    double yield_displacement;   ///< y [m]
    double growth_displacement;  ///< d [m]; 0: the limit does not depend on the displacement
    double travel;               ///< s [m]; 0: no wear
    double build_up_time;        ///< T_b [s]; 0: wear is permanent
    double dead_band;            ///< width of the play [m]
  };

  explicit VariableFriction(const Parameters& parameters) : parameters_(parameters) {}

  std::size_t memorySize() const override { return 3; }
  double initialise(double displacement, double* memory) const override {
    memory[kStretch] = 0.0;
    memory[kBristleState] = 1.0;
    memory[kWay] = displacement;
    return 0.0;
  }

  double relax(double displacement, double* memory) const override {
    memory[kStretch] = 0.0;
    memory[kWay] = displacement;
    if (parameters_.build_up_time > 0.0) {
      memory[kBristleState] = 1.0;
    }
    return 0.0;
  }

  double step(const Motion& motion, double* memory) const override {
    if (parameters_.travel > 0.0) {
      Motion way = motion;
      way.increment = advance(motion.displacement, parameters_.dead_band, memory[kWay]);
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
  Part part() const override { return Part::friction; }

 private:
  Parameters parameters_;
};

const ElementEntry kVariableFrictionEntry(
    280,
    {"variable_friction",
     "Friction behind a contact spring that slides at k y m (1 + |z|/d): the limit grows with displacement, wears with "
     "travel (m) and builds up again at rest.",
     {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k while the friction sticks"},
      {"yield_displacement", "m", Role::shape, Range::positive(),
       "displacement y of the spring at which the unworn friction slides near zero displacement"},
      {"growth_displacement", "m", Role::shape, Range::nonNegative(),
       "displacement d at which the limit is twice the limit at zero displacement; 0: no growth", 0.0},
      {"travel", "m", Role::shape, Range::nonNegative(), "travel s that wears the limit by a factor of e; 0: no wear",
       0.0},
      {"build_up_time", "s", Role::shape, Range::nonNegative(), "time T_b in which the limit builds up again; 0: never",
       0.0},
      {"dead_band", "m", Role::choice, Range::nonNegative(), kDeadBand, 0.0}},
     makes<VariableFriction, VariableFriction::Parameters>("stiffness", "yield_displacement", "growth_displacement",
                                                           "travel", "build_up_time", "dead_band")});

}  // namespace
}  // namespace rubber_suspension::element
