// Stress softening (Mullins effect): softer within displacements that were reached before.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Factor on the specimen's force: 1 - R tanh(u/w)/tanh(1/w), u = 1 - (z/S)^2 while |z| < S, and 1 at |z| >= S.
///
/// S is the softened reach, at most the largest past displacement M. With path length L = 0 it is M at once, so the
/// factor is 1 on the first loading and on from where a displacement is exceeded. With L > 0 it approaches M along the
/// way travelled, dS = (M - S)(1 - exp(-|dz|/L)), so that softening takes some cycles: about L/(4 A) of amplitude A.
/// Within S the force depends on z alone, the loss is that of the first loading. Symmetric in z.
/// Validity: softening is permanent here; the recovery of rubber over days is left out, and displacement stands for the
/// strain energy, which is right for a specimen of one shape under one kind of load.
/// Memory: M, S.
/// Source: pseudo-elasticity of R. W. Ogden and D. G. Roxburgh, Proc. R. Soc. A 455 (1999) 2861-2877; their error
/// function of the energy is a tanh here, u being the energy of a linear spring that lacks to the largest one, over the
/// latter.
class StressSoftening final : public ForceEffect {
 public:
  StressSoftening(double reduction /* R [-] */, double width /* w [-] */, double path /* L [m] */);

  std::size_t memorySize() const override { return 2; }
  void initialise(double displacement, double* memory) const override;
  double relax(double displacement, double* memory) const override;
  double step(const Motion& motion, const ComponentForce& force, double* memory) const override;

  /// The factor at a displacement [m] for a softened reach [m].
  double factor(double displacement, double reach) const;

 private:
  double reduction_;
  double width_;
  double path_;
  double deepest_;  // tanh(1/w)
};

ElementType stressSofteningType();

}  // namespace rubber_suspension::element
