// Hydraulic mount: a column of fluid in a track between two chambers, with or without a decoupler.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// m d2q/dt2 + c dq/dt + c_2 |dq/dt| dq/dt = F, F = k_h (z - q), with the displacement q of the fluid referred to the
/// pumping area A_p:
///   m = I A_p^2, c = R A_p^2, c_2 = R_2 A_p^3, k_h = A_p^2/C
/// (inertance I and resistances R, of laminar flow, and R_2, of ends, bends and turbulence, of the track, compliance C
/// of the upper chamber; the lower chamber is soft).
///   K* = k_h (m s^2 + c s)/(m s^2 + c s + k_h), s = i omega, for c_2 = 0
/// No force at rest, a peak of the loss near sqrt(k_h/m), k_h above it: the force of the fluid, to be put beside that
/// of the rubber. With a decoupler of free travel +-d the force is k_h D(z - q), D a dead zone of +-d: small motions of
/// high frequency do not move the column.
///
/// The step is exact for a displacement that is linear between samples, at any step length. With a decoupler it is
/// exact from one edge of the dead zone to the next; edges are sought between turns of the deflection, at most 4096
/// half periods of sqrt(k_h/m) a step, beyond which one may be missed. Memory: deflection z - q and rate dq/dt.
///
/// With c_2 > 0 the step is composed after Strang: half of the quadratic loss, exact by itself, the step above, the
/// other half. It loses energy in each part, and is of second order: a part is a quarter of a radian of sqrt(k_h/m), or
/// of the time m/(c_2 |dq/dt|), at most, and errs by 0.2 % of the largest force where c_2 |dq/dt| is 1.5 c, by a
/// quarter of that in half the step. A_p of the fluid's numbers does more than scale the force then, but no fit moves
/// it. Validity: no cavitation. Source: R. Singh, G. Kim and P. V. Ravindra, J. Sound and Vibration 158 (1992) 219-243;
/// dead zone of the decoupler and quadratic resistance as there; G. Strang, SIAM J. Numer. Anal. 5 (1968) 506-517. Its
/// type's make() throws std::invalid_argument where neither the mechanical nor the fluid parameters are complete, or
/// both are given.
class InertiaTrack final : public ParallelElement {
 public:
  InertiaTrack(double mass /* m [kg] */, double damping /* c [N s/m] */, double stiffness /* k_h [N/m] */,
               double free_travel /* d, to either side; 0: no decoupler [m] */,
               double quadratic_damping = 0.0 /* c_2 [N s^2/m^2] */);

  double mass() const { return mass_; }
  double damping() const { return damping_; }
  double stiffness() const { return stiffness_; }

  std::size_t memorySize() const override { return kMemorySize; }
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::viscous; }
  std::optional<std::complex<double>> complexStiffness(double omega) const override;

 private:
  enum Slot : std::size_t { kDeflection, kRate, kMemorySize };

  struct Flow {
    double deflection;  ///< z - q [m]
    double rate;        ///< dq/dt [m/s]
  };

  Flow coupled(Flow flow, double dt, double velocity) const;
  Flow free(Flow flow, double dt, double velocity) const;
  Flow along(int piece, Flow flow, double dt, double velocity) const;
  int pieceOf(Flow flow, double velocity) const;
  bool isIn(int piece, double deflection) const;
  double timeOfTurn(int piece, Flow flow, double dt, double velocity) const;
  double timeOfEdge(int piece, double edge, Flow flow, double dt, double velocity) const;
  void followDecoupled(Flow& flow, double dt, double velocity) const;
  double partsOf(double rate, double dt, double velocity) const;
  void brake(Flow& flow, double dt) const;

  double mass_;
  double damping_;
  double stiffness_;
  double free_travel_;
  double decay_;   // c/(2 m) [1/s]
  double square_;  // k_h/m [1/s^2]
  double brake_;   // c_2/m [1/m]
};

}  // namespace rubber_suspension::element
