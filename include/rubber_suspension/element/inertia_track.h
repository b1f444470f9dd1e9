// Hydraulic mount: a column of fluid in a track between two chambers, with or without a decoupler.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Simulates m d2q/dt2 + c dq/dt + c_2 |dq/dt| dq/dt = F, F = k_h (z - q), where the displacement q of the fluid is
/// referred to the pumping area A_p:
///   m = I A_p^2, c = R A_p^2, c_2 = R_2 A_p^3, k_h = A_p^2/C
/// with the inertance I of the track, its resistances R to laminar flow and R_2 due to ends, bends and turbulence, and
/// the compliance C of the upper chamber. The lower chamber has no stiffness.
///   K* = k_h (m s^2 + c s)/(m s^2 + c s + k_h), s = i omega, for c_2 = 0
/// The force is 0 at rest. Its loss peaks near the angular frequency sqrt(k_h/m), and its stiffness tends to k_h above
/// that frequency. The rubber of the mount needs elements of its own. With a decoupler of free travel +-d the force is
/// k_h D(z - q), where D is a dead zone of +-d: small motions of high frequency do not move the column.
///
/// The step is exact for a displacement that is linear between samples, at any step length. With a decoupler, a step is
/// split into at most 4096 parts that are shorter than half a period of sqrt(k_h/m), and each part is split at the
/// edges of the dead zone. If 4096 parts do not suffice, an edge may be missed. Memory: deflection z - q and rate
/// dq/dt.
///
/// With c_2 > 0 each part is a Strang splitting: half of the quadratic loss, the step without it, the other half. Each
/// of the three is solved exactly; their sequence is dissipative and of second order. A part dt is so short that dt
/// (sqrt(k_h/m) + c_2 |dq/dt|/m) is at most 1/4, unless the step exceeds 4 radians. The error is 0.2 % of the largest
/// force where c_2 |dq/dt| is 1.5 c, and a quarter of this for half the step. With R_2 > 0, A_p does not merely scale
/// the force, but fits never vary A_p. Validity: no cavitation. Source: R. Singh, G. Kim and P. V. Ravindra, J. Sound
/// and Vibration 158 (1992) 219-243, also for the dead zone of the decoupler and the quadratic resistance; G. Strang,
/// SIAM J. Numer. Anal. 5 (1968) 506-517. The make() of its type throws std::invalid_argument unless either the
/// mechanical or the fluid parameters are complete and the others absent.
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
