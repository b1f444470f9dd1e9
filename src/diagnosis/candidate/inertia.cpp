// Candidate effect: mass that moves with the displacement.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension {

namespace {

// m d2z/dt2 by central differences, per mass [N/kg].
Eigen::VectorXd acceleration(const Record& record) {
  const Eigen::Index inner = record.size() - 2;
  const Eigen::VectorXd& z = record.displacement;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(record.size());
  result.segment(1, inner) = (z.head(inner) - 2.0 * z.segment(1, inner) + z.tail(inner)) / (record.dt * record.dt);
  return result;
}

}  // namespace

Candidate inertiaCandidate(const Excitation& excitation) {
  const double omega = 6.28 * excitation.highest_frequency;
  Atom mass = additiveAtom("inertia", "mass", 0.05 * excitation.stiffness / (omega * omega));
  mass.on_rig = true;
  mass.exact = acceleration;
  return {"inertia", "moving fixture: error of stiffness grows with frequency squared, in phase", true, {mass}};
}

}  // namespace rubber_suspension
