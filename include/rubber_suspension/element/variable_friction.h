// Friction whose limit grows with displacement, wears with travel, and builds up again at rest. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// A Jenkins slider, a spring k that slides at the force k y m (1 + |z|/d).
///
/// With a displacement d the limit grows with the displacement, as where a seat is pressed the harder the farther it
/// moves: the loss grows faster than the amplitude. With a travel s the state m wears, dm/ds' = -m/s along the way s',
/// and with a build-up time T_b it returns at rest, dm/dt = (1 - m)/T_b - m |dz/dt|/s (thixotropy: the friction falls
/// with the rate). Without d, s and T_b it is Coulomb's friction behind a contact spring.
///
/// The force is linear in k, the others given. The slider's spring keeps its stiffness, only its limit moves, so the
/// law dissipates whatever the motion. m is exact for a displacement that is linear over the step, the limit is that at
/// its end. With a dead band the way is that behind play of this width, so that noise within it wears nothing.
/// Validity: one rate for wear and build-up. Memory: stretch of the spring [m], m, the displacement behind the play
/// [m]; a long rest builds m up unless T_b is 0, when wear is permanent. Source: C. F. Jenkin, Engineering 114 (1922)
/// 603; the state of a structure that motion breaks down: P. Haupt, K. Sedlan, Arch. Appl. Mech. 71 (2001) 89-109; P.
/// Hofer, A. Lion, J. Mech. Phys. Solids 57 (2009) 500-520.
class VariableFriction final : public ParallelElement {
 public:
  struct Parameters {
    double stiffness;                  ///< k [N/m]
    double yield_displacement;         ///< y [m]
    double growth_displacement = 0.0;  ///< d [m]; 0: the limit does not depend on the displacement
    double travel = 0.0;               ///< s [m]; 0: no wear
    double build_up_time = 0.0;        ///< T_b [s]; 0: what is worn stays so
    double dead_band = 0.0;            ///< of the way along which it wears [m]
  };

  explicit VariableFriction(const Parameters& parameters) : parameters_(parameters) {}

  std::size_t memorySize() const override { return 3; }
  double initialise(double displacement, double* memory) const override;
  double relax(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::friction; }

 private:
  Parameters parameters_;
};

ElementType variableFrictionType();

}  // namespace rubber_suspension::element
