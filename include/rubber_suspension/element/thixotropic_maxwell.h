// Maxwell element whose stiffness breaks down with motion and builds up at rest. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// dF/dt = k m dz/dt - F/tau, dm/dt = (1 - m)/T_b - m |dz/dt|/s, tau = 1/(2 pi f_b): a Maxwell element that softens
/// with the rate of the motion (Payne effect) and recovers over T_b. In steady motion of mean speed v the state is
/// m = 1/(1 + v T_b/s), so the stiffness falls with amplitude times frequency; relaxation beside friction, a sum,
/// cannot do that. m depends on the displacement alone, so the force is linear in k.
///
/// Exact for a displacement that is linear over the step. Settled cycles dissipate; it is not passive in the strict
/// sense, because force that was built up while m was large is given back over the longer way of a small one. Validity:
/// beside a spring and other elements that carry most of the force. Memory: the force, m.
/// Source: P. Haupt, K. Sedlan, Arch. Appl. Mech. 71 (2001) 89-109; P. Hofer, A. Lion, J. Mech. Phys. Solids 57 (2009)
/// 500-520.
class ThixotropicMaxwell final : public ParallelElement {
 public:
  struct Parameters {
    double stiffness;        ///< k [N/m]
    double break_frequency;  ///< f_b [Hz]
    double build_up_time;    ///< T_b [s]
    double travel;           ///< s [m]
  };

  explicit ThixotropicMaxwell(const Parameters& parameters);

  std::size_t memorySize() const override { return 2; }
  double initialise(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::viscous; }
  bool passive() const override { return false; }

 private:
  Parameters parameters_;
  double rate_;  // 1/tau [1/s]
};

ElementType thixotropicMaxwellType();

}  // namespace rubber_suspension::element
