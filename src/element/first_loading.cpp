// Force of the first loading.
#include "rubber_suspension/element/first_loading.h"

#include <algorithm>
#include <cmath>

#include "element/dead_band.h"

namespace rubber_suspension::element {
namespace {

enum FirstLoadingSlot { kUpper, kLower, kFollowed };

}  // namespace

double FirstLoading::initialise(double displacement, double* memory) const {
  memory[kUpper] = std::max(displacement, 0.0);
  memory[kLower] = std::max(-displacement, 0.0);
  memory[kFollowed] = displacement;
  return 0.0;
}

// Rest at a displacement not reached before relaxes the force there: the reach continues to it.
double FirstLoading::relax(double displacement, double* memory) const {
  memory[kUpper] = std::max(memory[kUpper], displacement);
  memory[kLower] = std::max(memory[kLower], -displacement);
  memory[kFollowed] = displacement;
  return 0.0;
}

// Solution of dd/dz = 1 - d/(b z) from where the motion leaves the reach.
double FirstLoading::follow(double end, double increment, double& reach) const {
  const double start = std::max(end - increment, reach);
  if (end <= start) {
    return std::max(end - reach, 0.0);
  }
  const double limit = yield_share_ / (1.0 + yield_share_);
  const double kept = std::pow(start / end, 1.0 / yield_share_);
  const double beyond = limit * end + (start - reach - limit * start) * kept;
  reach = end - beyond;
  return beyond;
}

double FirstLoading::step(const Motion& motion, double* memory) const {
  const double z = followed(motion.displacement, dead_band_, memory[kFollowed]);
  const double increment = dead_band_ > 0.0 ? z - memory[kFollowed] : motion.increment;
  memory[kFollowed] = z;
  const double upper = side_ == Side::lower ? 0.0 : follow(z, increment, memory[kUpper]);
  const double lower = side_ == Side::upper ? 0.0 : follow(-z, -increment, memory[kLower]);
  return stiffness_ * (upper - lower);
}

ElementType firstLoadingType() {
  return {
      "first_loading",
      "What a new test piece carries beyond displacements that were reached before: k beyond them, k b |z|/(1 + b) "
      "at most, and gone within some cycles.",
      {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k just beyond the largest past displacement"},
       {"yield_share", "1", Role::shape, Range::closed(1e-3, 1e3),
        "share b of the displacement over which the force approaches its limit"},
       {"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: at z > 0 only, -1: at z < 0 only, 0: both", 0.0},
       {"dead_band", "m", Role::choice, Range::nonNegative(), kDeadBand, 0.0}},
      [](const ElementDescription& description) -> ElementPointer {
        return std::make_shared<const FirstLoading>(description.value("stiffness"), description.value("yield_share"),
                                                    static_cast<FirstLoading::Side>(sideOf(description, "z")),
                                                    description.value("dead_band"));
      }};
}

}  // namespace rubber_suspension::element
