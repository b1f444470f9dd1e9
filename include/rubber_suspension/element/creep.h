// Creep: force that relaxes by the same amount in every decade of time under a hold.
#pragma once

#include "rubber_suspension/element/maxwell_bank.h"

namespace rubber_suspension::element {

/// After a step of displacement z the force falls by S z per decade of time, between the shortest and the longest time.
/// Realised by two Maxwell elements per decade with equal stiffness S/2 and relaxation times in geometric progression,
/// at the middles (on a log axis) of equal bands; the slope then ripples by less than 0.5 % away from the ends.
/// Right after the step it adds S z for each decade, so it stiffens what is faster than the shortest time.
/// Validity: between the two times; before and after the force is constant. Towards the longest time T the slope falls
/// as exp(-t/T): by 10 % at T/10. Its make() throws std::invalid_argument for times out of order.
/// Source: A. N. Gent, J. Appl. Polym. Sci. 6 (1962) 433-441 (stress relaxation linear in log t).
class Creep final : public MaxwellBank {
 public:
  Creep(double stiffness_per_decade /* S [N/m] */, double shortest_time /* [s] */, double longest_time /* [s] */);
};

ElementType creepType();

}  // namespace rubber_suspension::element
