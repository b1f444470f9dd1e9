// Bouc-Wen hysteresis: rate-independent friction whose loading and unloading curve by different amounts.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// dh/dt = A dz/dt - beta |dz/dt| |h|^(n-1) h - gamma dz/dt |h|^n, F = h: the hysteretic part alone; the stiffness and
/// the damping of the standard form are a `spring` and a `dashpot` beside it.
///
/// From rest the force rises with the stiffness A and tends to (A/(beta + gamma))^(1/n); the larger the exponent n, the
/// sharper the bend before it. Unloading starts with the slope A + (beta - gamma) |h|^n. For beta >= |gamma| the energy
/// h^2/(2 A) never grows by more than the work done, so the law dissipates. With gamma = -beta there is no limit.
/// Minor loops do not close; `iwan` closes them.
///
/// Exact for n = 1. Otherwise the law is integrated over the way by Runge-Kutta steps that are short against the bend:
/// the error stays below 1e-6 of (A/beta)^(1/n) for n up to 20, whatever the step. Memory: the force.
/// Source: Y.-K. Wen, J. Eng. Mech. Div. ASCE 102 (1976) 249-263; as a model of rubber: Kim et al., reference 11 of
/// Polach (IAVSD 2015); dissipation: M. Ismail, F. Ikhouane and J. Rodellar, Arch. Comput. Methods Eng. 16 (2009)
/// 161-188. Its type's make() throws std::invalid_argument where beta < |gamma|.
class BoucWen final : public ParallelElement {
 public:
  BoucWen(double stiffness /* A [N/m] */, double beta /* [N^(1-n)/m] */, double gamma /* [N^(1-n)/m] */,
          double exponent /* n [-] */);

  /// Force [N] that a long way in one direction tends to; infinite for gamma = -beta.
  double limit() const { return scale_ * limit_; }

  std::size_t memorySize() const override { return 1; }
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::friction; }

 private:
  double rate(double q) const;
  double wayFromZero(double q) const;
  double nearZero(double way) const;
  double rungeKutta(double q, double way) const;
  double afterOfExponentOne(double q, double way) const;
  double after(double q, double way) const;

  double stiffness_;
  double exponent_;
  double asymmetry_;  // gamma/beta [-]
  double scale_;      // (A/beta)^(1/n) [N]
  double limit_;      // over the scale [-]
  double near_;       // likewise, up to which the bend at zero counts [-]
};

ElementType boucWenType();

}  // namespace rubber_suspension::element
