// Self-heating: hard work warms the rubber, which softens it. Throws nothing: makeElement() checks the values.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Factor on the test piece's force: 1 - x, at least 0.2 and at most 1, with dx/dt = s P - x/T.
/// x is the temperature rise times the relative softening per kelvin; P the power that the viscous and friction parts
/// take up (softened ones); s = (softening per kelvin)/(heat capacity); T = (heat capacity)/(heat transfer). Under
/// settled work x tends to s T (mean P). Stiffness and loss force fall alike. Each step takes the mean force of its
/// ends and decays x exactly. Validity: one temperature for the whole test piece; ambient temperature and the shift of
/// frequencies are left out. Memory: x, the loss force of the step before. Source: lumped heat balance, e.g. A. R.
/// Johnson and T.-K. Chen, Comput. Methods Appl. Mech. Eng. 194 (2005) 313-325.
class SelfHeating final : public ForceEffect {
 public:
  static constexpr double kLeastFactor = 0.2;

  SelfHeating(double energy_sensitivity /* s [1/J] */, double time_constant /* T [s] */)
      : energy_sensitivity_(energy_sensitivity), time_constant_(time_constant) {}

  std::size_t memorySize() const override { return 2; }
  void initialise(double displacement, double* memory) const override;
  double step(const Motion& motion, const ComponentForce& force, double* memory) const override;
  bool passive() const override { return false; }

 private:
  double energy_sensitivity_;
  double time_constant_;
};

ElementType selfHeatingType();

}  // namespace rubber_suspension::element
