// Force of the first loading: what a new test piece carries beyond displacements that were reached before.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

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
/// 601-612. The type's make() throws std::invalid_argument for values that do not go together.
class FirstLoading final : public ParallelElement {
 public:
  enum class Side { lower = -1, both = 0, upper = 1 };

  FirstLoading(double stiffness /* k [N/m] */, double yield_share /* b [-] */, Side side = Side::both,
               double dead_band = 0.0 /* [m] */)
      : stiffness_(stiffness), yield_share_(yield_share), side_(side), dead_band_(dead_band) {}

  std::size_t memorySize() const override { return 3; }
  double initialise(double displacement, double* memory) const override;
  double relax(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::friction; }

 private:
  /// Moves a reach along with an outward motion to `end` [m] by `increment` [m]; returns how far `end` lies beyond.
  double follow(double end, double increment, double& reach) const;

  double stiffness_;
  double yield_share_;
  Side side_;
  double dead_band_;
};

ElementType firstLoadingType();

}  // namespace rubber_suspension::element
