// Spring and dashpot of any power in series behind a play: a hydraulic damper in a worn eye. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// F = k d(z - w), dw/dt = v_r sign(F) (|F|/(k y))^(1/p), with the dead zone d(x) = x - clamp(x, -g, g): a damper whose
/// force is k y (v/v_r)^p in steady flow, reached over a spring once the clearance g to either side is used up. p = 2:
/// an orifice; p < 1: a damper that blows off, or a fluid that thins. After each reversal there is no force for 2 g of
/// travel. The force is linear in k, the others given; p = 1 is maxwell_behind_play.
///
/// The flow of a step is that at its end (flowRoot()): exact in steady flow, of first order in the step else, and it
/// dissipates at any step. Validity: contact without impact or friction of the joint. Memory: where the damper's piston
/// stands. Source: J. C. Dixon, The Shock Absorber Handbook, 2nd ed. 2007, chapter 5, behind the dead zone of
/// maxwell_behind_play.
class PowerDashpotBehindPlay final : public ParallelElement {
 public:
  struct Parameters {
    double stiffness;       // k [N/m]
    double displacement;    // y [m]
    double reference_rate;  // v_r [m/s]
    double exponent;        // p [-]
    double gap;             // g, to either side [m]
  };

  explicit PowerDashpotBehindPlay(const Parameters& parameters) : parameters_(parameters) {}

  std::size_t memorySize() const override { return 1; }
  double initialise(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::viscous; }

 private:
  Parameters parameters_;
};

ElementType powerDashpotBehindPlayType();

}  // namespace rubber_suspension::element
