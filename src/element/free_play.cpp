// Free play: a dead zone in which the test piece is not moved.
#include <algorithm>

#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// The test piece sees z - s clamp(z, -g, g): with the share s = 1 nothing within the gap and all that exceeds it
/// beyond; with less, a seat that gives way within the gap. Entries one after the other make a gap with soft edges.
/// Lowers the stiffness at small amplitude, opposite to friction: K(A) = K (1 - s g/A).
/// Validity: loss of contact without impact, the gap centred at zero displacement. A component applies it behind the
/// delay and before the series compliance.
class FreePlay final : public DisplacementEffect {
 public:
  FreePlay(double gap /* g, to either side [m] */, double share /* s [-] */) : gap_(gap), share_(share) {}

  double behind(double displacement) const { return displacement - share_ * std::clamp(displacement, -gap_, gap_); }

  double initialise(double displacement, double* /*memory*/) const override { return behind(displacement); }
  double step(const Motion& motion, double* /*memory*/) const override { return behind(motion.displacement); }

 private:
  double gap_;
  double share_;
};

const ElementEntry kFreePlayEntry(390, {"free_play",
                                        "Dead zone of displacement in which the test piece does not move.",
                                        {{"gap", "m", Role::shape, Range::positive(),
                                          "width g of the dead zone to either side of zero"},
                                         {"share", "1", Role::shape, Range::openBelow(0.0, 1.0),
                                          "share s of the motion within the dead zone that is lost", 1.0}},
                                        makes<FreePlay>("gap", "share")});

}  // namespace
}  // namespace rubber_suspension::element
