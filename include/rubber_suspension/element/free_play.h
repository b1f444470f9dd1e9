// Free play: a dead zone in which the specimen is not moved.
#pragma once

#include <algorithm>

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension {

/// The specimen sees z - clamp(z, -g, g): nothing within the gap, all that exceeds it beyond.
/// Lowers the stiffness at small amplitude, opposite to friction: K(A) = K (1 - g/A).
/// Validity: loss of contact without impact, the gap centred at zero displacement.
class FreePlay final : public DisplacementEffect {
 public:
  explicit FreePlay(double gap /* g, to either side [m] */) : gap_(gap) {}

  double behind(double displacement) const { return displacement - std::clamp(displacement, -gap_, gap_); }

  double rest(double displacement, double* /*memory*/) const override { return behind(displacement); }
  double step(const Motion& motion, double* /*memory*/) const override { return behind(motion.displacement); }

 private:
  double gap_;
};

ElementType freePlayType();

}  // namespace rubber_suspension
