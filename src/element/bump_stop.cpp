// Bump stop: an additional spring that comes into contact beyond a gap.
#include <cmath>

#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// Simulates F = k_s d (d/d_ref)^(p-1) in the direction of z, with the depth d = max(|z| - g, 0), on one side or on
/// both sides. No loss. k_s is the secant stiffness at the reference depth; for p = 1 the stop is linear and d_ref has
/// no influence. Validity: contact without impact, and a stop without damping.
/// Source: contact law F = K d^p of Hertz (p = 3/2) as used by Hunt and Crossley, J. Appl. Mech. 42 (1975) 440-445.
class BumpStop final : public ParallelElement {
 public:
  enum class Side { lower = -1, both = 0, upper = 1 };

  BumpStop(double stiffness /* k_s [N/m] */, double gap /* g [m] */, double exponent /* p [-] */,
           double reference_depth /* d_ref [m] */, Side side)
      : stiffness_(stiffness), gap_(gap), exponent_(exponent), reference_depth_(reference_depth), side_(side) {}

  double force(double displacement) const {
    const double depth = std::abs(displacement) - gap_;
    const bool beside = (side_ == Side::upper && displacement < 0.0) || (side_ == Side::lower && displacement > 0.0);
    if (depth <= 0.0 || beside) {
      return 0.0;
    }
    const double progression = exponent_ == 1.0 ? 1.0 : std::pow(depth / reference_depth_, exponent_ - 1.0);
    return std::copysign(stiffness_ * depth * progression, displacement);
  }

  double initialise(double displacement, double* /*memory*/) const override { return force(displacement); }
  double step(const Motion& motion, double* /*memory*/) const override { return force(motion.displacement); }
  Part part() const override { return Part::elastic; }

 private:
  double stiffness_;
  double gap_;
  double exponent_;
  double reference_depth_;
  Side side_;
};

const ElementEntry kBumpStopEntry(
    60,
    {"bump_stop",
     "Bump stop: F = k_s d (d/d_ref)^(p-1) with the depth d of contact beyond a gap.",
     {{"stiffness", "N/m", Role::scale, Range::positive(), "secant stiffness k_s at the reference depth"},
      {"gap", "m", Role::shape, Range::nonNegative(), "displacement at which the stop comes into contact"},
      {"exponent", "1", Role::shape, Range::closed(1.0, 3.0), "exponent p of the force over the depth; 1 is linear",
       1.0},
      {"reference_depth", "m", Role::reference, Range::positive(),
       "depth d_ref at which the stop has the stiffness k_s", 0.001},
      {"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: stop at z > 0 only, -1: at z < 0 only, 0: both", 0.0}},
     [](const ElementDescription& description) -> ElementPointer {
       return std::make_shared<const BumpStop>(description.value("stiffness"), description.value("gap"),
                                               description.value("exponent"), description.value("reference_depth"),
                                               static_cast<BumpStop::Side>(sideOf(description, "z")));
     }});

}  // namespace
}  // namespace rubber_suspension::element
