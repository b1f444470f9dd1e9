// Force of the first loading: what a new test piece carries beyond displacements that were reached before.
#include <algorithm>
#include <cmath>

#include "element/dead_band.h"
#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

enum FirstLoadingSlot { kUpper, kLower, kFollowed };

/// F = k d, d = |z| - S beyond the reach S of a side, towards that side, and 0 within. Moving outwards beyond S the
/// reach follows, dS = d/(b |z|) d|z|, so that d tends to b |z|/(1 + b): the first loading carries k b |z|/(1 + b) more
/// than the rubber does later. Moving inwards S stays; a second loading has less of it, each further one less again,
/// and after n cycles about b/n of the displacement is left.
///
/// It is the additive part of stress softening, of filler that breaks: a factor on the force (stress_softening) cannot
/// add to the first loading alone, nor to its loss. Each side has a reach of its own. Rate-independent, exact for any
/// step, dissipates. The reach is permanent: a long rest keeps it. With a dead band the displacement is that behind
/// play of this width: noise within it, which would move the reach on with every sample, moves nothing. Memory: the
/// reaches of the upper and the lower side, and the displacement behind the play. Source: yielding at a limit that is
/// approached smoothly (P. R. Dahl, AIAA J. 14 (1976) 1675-1682), one-sided and irreversible; that the first loading
/// alone breaks filler, and the more the farther it goes: J. Diani, B. Fayolle, P. Gilormini, Eur. Polymer J. 45 (2009)
/// 601-612.
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

  // Rest at a displacement not reached before relaxes the force there: the reach continues to it.
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
  /// Moves a reach along with an outward motion to `end` [m] by `increment` [m]; returns how far `end` lies beyond.
  // Solution of dd/dz = 1 - d/(b z) from where the motion leaves the reach.
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
            "share b of the displacement over which the force approaches its limit"},
           {"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: at z > 0 only, -1: at z < 0 only, 0: both", 0.0},
           {"dead_band", "m", Role::choice, Range::nonNegative(), kDeadBand, 0.0}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const FirstLoading>(
                description.value("stiffness"), description.value("yield_share"),
                static_cast<FirstLoading::Side>(sideOf(description, "z")), description.value("dead_band"));
          }});

}  // namespace
}  // namespace rubber_suspension::element
