// Additional force of a new test piece beyond the largest past displacement.
#include <algorithm>
#include <cmath>

#include "element/dead_band.h"
#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

enum FirstLoadingSlot { kUpper, kLower, kFollowed };

/// Simulates F = k d towards the side of z, with d = |z| - S beyond the reach S of that side, and F = 0 within the
/// reach. During outward motion beyond S the reach follows, dS = d/(b |z|) d|z|, so that d tends to b |z|/(1 + b). So
/// the first loading needs up to k b |z|/(1 + b) more force than later loadings. During inward motion S is constant.
/// The additional force decreases with each further loading; after n cycles d is about b |z|/n.
///
/// The law is the additive part of stress softening, due to filler that breaks. It is needed because a factor on the
/// force (stress_softening) can increase neither the force of the first loading alone nor its loss. Each side has its
/// own reach, which a long rest does not reduce. The law is rate-independent and dissipates; its step has no error at
/// any length. With a dead band, z is the displacement behind play of this width, because noise would otherwise extend
/// the reach with every sample. Memory: the reaches of the upper and the lower side, and the displacement behind the
/// play. Source: yielding at a limit that is approached smoothly (P. R. Dahl, AIAA J. 14 (1976) 1675-1682), here
/// one-sided and irreversible; filler breaks only on first loading, and more at larger strain: J. Diani, B. Fayolle, P.
/// Gilormini, Eur. Polymer J. 45 (2009) 601-612.
class FirstLoading final : public ParallelElement {
 public:
  enum class Side { lower = -1, both = 0, upper = 1 };

  FirstLoading(double stiffness /* k [N/m] */, double yield_share /* b [-] */, Side side, double dead_band /* [m] */)
      : stiffness_(stiffness), yield_share_(yield_share), side_(side), dead_band_(dead_band) {}

  std::size_t memorySize() const override { return 3; }
  double initialise(double displacement, double* memory) const override {
    memory[kUpper] = std::max(displacement, 0.0);
    memory[kLower] = std::max(-displacement, 0.0);
    memory[kFollowed] = displacement;
    return 0.0;
  }

  // A long rest beyond the reach relaxes the force to 0, so it extends the reach to the present displacement.
  double relax(double displacement, double* memory) const override {
    memory[kUpper] = std::max(memory[kUpper], displacement);
    memory[kLower] = std::max(memory[kLower], -displacement);
    memory[kFollowed] = displacement;
    return 0.0;
  }

  double step(const Motion& motion, double* memory) const override {
    const double z = followed(motion.displacement, dead_band_, memory[kFollowed]);
    const double increment = dead_band_ > 0.0 ? z - memory[kFollowed] : motion.increment;
    memory[kFollowed] = z;
    const double upper = side_ == Side::lower ? 0.0 : follow(z, increment, memory[kUpper]);
    const double lower = side_ == Side::upper ? 0.0 : follow(-z, -increment, memory[kLower]);
    return stiffness_ * (upper - lower);
  }
  Part part() const override { return Part::friction; }

 private:
  /// Extends a reach by a motion of `increment` [m] to `end` [m] and returns d at `end` [m]. The solution of dd/dz = 1
  /// - d/(b z) starts where the motion exceeds the reach.
  double follow(double end, double increment, double& reach) const {
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

  double stiffness_;
  double yield_share_;
  Side side_;
  double dead_band_;
};

const ElementEntry kFirstLoadingEntry(
    320, {"first_loading",
          "Additional force of a new test piece beyond the largest past displacement: stiffness k there, force at most "
          "k b |z|/(1 + b); it vanishes within some cycles.",
          {{"stiffness", "N/m", Role::scale, Range::positive(),
            "additional stiffness k just beyond the largest past displacement"},
           {"yield_share", "1", Role::shape, Range::closed(1e-3, 1e3),
            "share b: the force approaches its limit within b times the displacement"},
           {"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: at z > 0 only, -1: at z < 0 only, 0: both", 0.0},
           {"dead_band", "m", Role::choice, Range::nonNegative(), kDeadBand, 0.0}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const FirstLoading>(
                description.value("stiffness"), description.value("yield_share"),
                static_cast<FirstLoading::Side>(sideOf(description, "z")), description.value("dead_band"));
          }});

}  // namespace
}  // namespace rubber_suspension::element
