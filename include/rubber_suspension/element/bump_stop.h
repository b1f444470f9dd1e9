// Bump stop: a further spring that comes into contact beyond a gap. Its make() throws std::invalid_argument.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// F = k_s d (d/d_ref)^(p-1) with the depth d = (|z| - g)_+, directed as z, on one side or on both. No loss.
/// k_s is the secant stiffness at the reference depth; for p = 1 the stop is linear and d_ref without influence.
/// Validity: contact without impact; the rebound of a stop with damping of its own needs a law of its own.
/// Source: contact law F = K d^p of Hertz (p = 3/2) as used by Hunt and Crossley, J. Appl. Mech. 42 (1975) 440-445.
class BumpStop final : public ParallelElement {
 public:
  enum class Side { lower = -1, both = 0, upper = 1 };

  BumpStop(double stiffness /* k_s [N/m] */, double gap /* g [m] */, double exponent /* p [-] */,
           double reference_depth /* d_ref [m] */, Side side)
      : stiffness_(stiffness), gap_(gap), exponent_(exponent), reference_depth_(reference_depth), side_(side) {}

  double force(double displacement) const;

  double initialise(double displacement, double* /*memory*/) const override { return force(displacement); }
  double step(const Motion& motion, double* /*memory*/) const override { return force(motion.displacement); }
  Part part() const override { return Part::elastic; }

 private:
  double stiffness_;
  double gap_;
  double exponent_;
  double reference_depth_;
  Side side_;
};

ElementType bumpStopType();

}  // namespace rubber_suspension::element
