// Free play: a dead zone in which the test piece does not move.
#include <algorithm>

#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// Reduces the displacement of the test piece to z - s clamp(z, -g, g). For a share s = 1 the test piece does not move
/// while |z| <= g and moves by |z| - g beyond. A smaller share describes a seat that yields within the gap. Several
/// entries in sequence form a gap with soft edges. Play lowers the stiffness at small amplitudes, K(A) = K (1 - s g/A),
/// whereas friction raises it. Validity: loss of contact without impact, and a gap centred at zero displacement. A
/// component applies free play after the delay and before the series compliance.
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
                                          "share s of the motion that is lost within the dead zone", 1.0}},
                                        makes<FreePlay>("gap", "share")});

}  // namespace
}  // namespace rubber_suspension::element
