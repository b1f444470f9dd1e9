// Stress softening (Mullins effect): softer within displacements that were reached before.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Factor on the test piece's force: 1 - R(S) tanh(u/w)/tanh(1/w), u = 1 - |z/S|^a while |z| < S, and 1 at |z| >= S.
///
/// S is the softened reach, at most the largest past displacement M. With path length L = 0 it is M at once, so the
/// factor is 1 on the first loading and on from where a displacement is exceeded. With L > 0 it approaches M along the
/// way travelled, dS = (M - S)(1 - exp(-|dz|/L)), so that softening takes some cycles: about L/(4 A) of amplitude A.
/// Within S the force depends on z alone, the loss is that of the first loading.
///
/// The reduction grows with the reach, R(S) = R min(S/S_f, 1)^q; for q = 0 it is R whatever the reach.
/// With a side, only displacement to that side counts and is softened, by the part that lies there: from nothing at S/4
/// beyond zero to all at S/4 on the side itself, so that the force has no jump.
/// With a recovery time T, M and S return to the present displacement, dM/dt = -(M - |z|)/T; without it softening is
/// permanent, as it is over the hours of a test.
/// Validity: displacement stands for the strain energy, which is right for a test piece of one shape under one kind of
/// load. Memory: M, S.
/// Source: pseudo-elasticity of R. W. Ogden and D. G. Roxburgh, Proc. R. Soc. A 455 (1999) 2861-2877; their error
/// function of the energy is a tanh here, u being for a = 2 the energy of a linear spring that lacks to the largest
/// one, over the latter; a = 1 counts displacement as M. F. Beatty and S. Krishnaswamy, J. Mech. Phys. Solids 48 (2000)
/// 1931-1965, count strain. That the reduction grows with the largest strain, and recovers: J. Diani, B. Fayolle, P.
/// Gilormini, Eur. Polymer J. 45 (2009) 601-612. The type's make() throws std::invalid_argument for values that do not
/// go together.
class StressSoftening final : public ForceEffect {
 public:
  enum class Side { lower = -1, both = 0, upper = 1 };

  struct Parameters {
    double reduction;             ///< R [-]
    double width;                 ///< w [-]
    double path;                  ///< L [m]; 0: at once
    double reach_exponent = 0.0;  ///< q [-]
    double full_reach = 0.0;      ///< S_f [m]; greater than 0 beside an exponent
    double recovery_time = 0.0;   ///< T [s]; 0: permanent
    Side side = Side::both;
    double ratio_power = 2.0;  ///< a [-]
  };

  explicit StressSoftening(const Parameters& parameters);

  std::size_t memorySize() const override { return 2; }
  void initialise(double displacement, double* memory) const override;
  double relax(double displacement, double* memory) const override;
  double step(const Motion& motion, const ComponentForce& force, double* memory) const override;

  /// The factor at a displacement [m] for a softened reach [m].
  double factor(double displacement, double reach) const;

 private:
  /// How far a displacement reaches to the side that counts [m].
  double reachOf(double displacement) const;
  /// Part of a displacement that lies on the side that counts [-].
  double shareOfSide(double displacement, double reach) const;
  double reductionAt(double reach) const;
  void recover(double dt, double reached, double* memory) const;

  Parameters parameters_;
  double deepest_;  // tanh(1/w)
};

ElementType stressSofteningType();

}  // namespace rubber_suspension::element
