// Branches in series with their own clearance: a slider, a damper with backlash, and a hydraulic damper in a worn eye.
#include <algorithm>
#include <cmath>

#include "element/implicit_flow.h"
#include "element/registry.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {
namespace {

/// Simulates F = k d(z - w), with the dead zone d(x) = x - clamp(x, -g, g): a spring with a clearance g to either side
/// of w, in series with a branch that moves w. While free play acts on the whole test piece, this clearance acts on one
/// branch and moves with it: after each reversal the force is 0 over a travel of 2 g at any amplitude. At amplitudes
/// below g the settled force is 0. The force is linear in k for given other parameters. The law dissipates. Validity:
/// contact without impact or friction of the joint. Memory: w.
template <class Branch>
class BehindPlay final : public ParallelElement {
 public:
  BehindPlay(double stiffness /* k [N/m] */, double gap /* g, to either side [m] */, const Branch& branch)
      : stiffness_(stiffness), gap_(gap), branch_(branch) {}

  std::size_t memorySize() const override { return 1; }
  double initialise(double displacement, double* memory) const override {
    memory[0] = displacement;
    return 0.0;
  }

  double step(const Motion& motion, double* memory) const override {
    return stiffness_ * branch_.stretch(motion, gap_, memory[0]);
  }
  Part part() const override { return Branch::kPart; }

 private:
  double stiffness_;
  double gap_;
  Branch branch_;
};

double deadZone(double offset, double gap) { return offset - std::clamp(offset, -gap, gap); }

/// A slider that moves at the force k y. The settled loss per cycle is 4 k y (A - g - y) at an amplitude A > g + y. The
/// law is rate-independent, and its step has no error at any length. Source: elastic-plastic element with a gap, e.g.
/// K. Worden, G. R. Tomlinson, Nonlinearity in Structural Dynamics (2001).
struct Slider {
  static constexpr Part kPart = Part::friction;

  double yield_displacement;  ///< y [m]

  double stretch(const Motion& motion, double gap, double& place) const {
    const double reach = gap + yield_displacement;
    place = std::clamp(place, motion.displacement - reach, motion.displacement + reach);
    return deadZone(motion.displacement - place, gap);
  }
};

/// A damper, dw/dt = F/c, c = k/(2 pi f_b): together with the spring a Maxwell element for g = 0, a dashpot with
/// backlash for a high f_b. The step is exact for a displacement that is linear over it, since contact and free flight
/// have closed solutions. Source: dead zone in series with linear dynamics, e.g. M. Nordin, P.-O. Gutman, Automatica 38
/// (2002) 1633-1649.
struct Damper {
  static constexpr Part kPart = Part::viscous;

  explicit Damper(double break_frequency /* f_b [Hz] */) : relaxation_time(1.0 / (2.0 * kPi * break_frequency)) {}

  double relaxation_time;  ///< tau [s]

  double stretch(const Motion& motion, double gap, double& place) const {
    const double start = motion.displacement - motion.increment - place;
    const double offset = offsetAfter(start, motion.increment / motion.dt, motion.dt, gap);
    place = motion.displacement - offset;
    return deadZone(offset, gap);
  }

  /// Returns z - w [m] after `time` [s] at constant velocity. The contact on the side of `offset` may end and be
  /// followed by free flight and by contact on the other side.
  double offsetAfter(double offset, double velocity, double time, double gap) const {
    const double depth = std::abs(offset) - gap;
    if (depth > 0.0) {
      const double inward = std::copysign(velocity, velocity * offset);  // positive towards deeper contact
      const double lasts = inward < 0.0 ? relaxation_time * std::log1p(-depth / (relaxation_time * inward)) : time;
      if (lasts >= time) {
        return std::copysign(gap + depthAfter(depth, inward, time), offset);
      }
      offset = std::copysign(gap, offset);
      time -= lasts;
    }
    const double speed = std::abs(velocity);
    const double way = gap - std::copysign(offset, velocity * offset);
    if (speed * time <= way) {
      return offset + velocity * time;
    }
    return std::copysign(gap + depthAfter(0.0, speed, time - way / speed), velocity);
  }

  /// Returns the depth of contact [m] after `time` [s] of motion into contact at `velocity` [m/s]: dd/dt = v - d/tau.
  double depthAfter(double depth, double velocity, double time) const {
    const Relaxation relaxation = Relaxation::over(time / relaxation_time);
    return relaxation.decay * depth + relaxation.mean * velocity * time;
  }
};

/// A damper whose force in steady flow is k y (v/v_r)^p: dw/dt = v_r sign(F) (|F|/(k y))^(1/p). It is an orifice for p
/// = 2, a relief valve or a shear-thinning fluid for p < 1, and maxwell_behind_play for p = 1. The step is implicit
/// Euler (flowRoot()), which is exact in steady flow, otherwise of first order, and dissipative at any step length.
/// Source: J. C. Dixon, The Shock Absorber Handbook, 2nd ed. 2007, chapter 5, behind the dead zone of
/// maxwell_behind_play.
struct PowerDamper {
  static constexpr Part kPart = Part::viscous;

  double displacement;    ///< y [m]
  double reference_rate;  ///< v_r [m/s]
  double exponent;        ///< p [-]

  double stretch(const Motion& motion, double gap, double& place) const {
    const double offset = motion.displacement - place;
    const double depth = std::abs(offset) - gap;  // depth at the end of the step if the damper did not move
    if (depth <= 0.0) {
      return 0.0;
    }
    const double way = std::abs(motion.increment);
    const double contact = way > depth ? depth / way : 1.0;  // share of the step in contact
    const double flow = reference_rate * contact * motion.dt / displacement;
    const double left = displacement * flowRoot(depth / displacement, flow, 1.0 / exponent);
    place = motion.displacement - std::copysign(gap + left, offset);
    return std::copysign(left, offset);
  }
};

/// Returns a function that makes a branch with its clearance. `names` are the parameters of the branch.
template <class Branch, class... Names>
auto makesBehindPlay(Names... names) {
  return [=](const ElementDescription& description) -> ElementPointer {
    return std::make_shared<const BehindPlay<Branch>>(description.value("stiffness"), description.value("gap"),
                                                      Branch{description.value(names)...});
  };
}

const ElementEntry kMaxwellBehindPlayEntry(
    150, {"maxwell_behind_play",
          "Spring and dashpot in series with a clearance: a damper with backlash.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the spring"},
           {"break_frequency", "Hz", Role::shape, Range::positive(),
            "break frequency f_b; for a dashpot c alone, choose a high f_b and k = 2 pi f_b c"},
           {"gap", "m", Role::shape, Range::positive(), "clearance g to either side"}},
          makesBehindPlay<Damper>("break_frequency")});

const ElementEntry kPowerDashpotBehindPlayEntry(
    160, {"power_dashpot_behind_play",
          "Spring and power-law dashpot in series with a clearance: a hydraulic damper in a worn eye, F = k y "
          "(v/v_r)^p in steady flow.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the spring"},
           {"displacement", "m", Role::shape, Range::positive(),
            "displacement y of the spring in steady flow at the rate v_r"},
           {"reference_rate", "m/s", Role::shape, Range::positive(), "rate v_r"},
           {"exponent", "1", Role::shape, Range::closed(0.1, 4.0), "power p; 1: a linear dashpot"},
           {"gap", "m", Role::shape, Range::positive(), "clearance g to either side"}},
          makesBehindPlay<PowerDamper>("displacement", "reference_rate", "exponent")});

const ElementEntry kFrictionBehindPlayEntry(
    310, {"friction_behind_play",
          "Friction in series with a clearance: there is no friction over 2 g of travel after each reversal.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k while the friction sticks"},
           {"yield_displacement", "m", Role::shape, Range::positive(),
            "displacement y beyond the clearance at which the friction slides"},
           {"gap", "m", Role::shape, Range::positive(), "clearance g to either side"}},
          makesBehindPlay<Slider>("yield_displacement")});

}  // namespace
}  // namespace rubber_suspension::element
