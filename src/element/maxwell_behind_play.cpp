// Damper with backlash.
#include "rubber_suspension/element/maxwell_behind_play.h"

#include <algorithm>
#include <cmath>

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {

MaxwellBehindPlay::MaxwellBehindPlay(double stiffness, double break_frequency, double gap)
    : stiffness_(stiffness), relaxation_time_(1.0 / (2.0 * kPi * break_frequency)), gap_(gap) {}

double MaxwellBehindPlay::initialise(double displacement, double* memory) const {
  memory[0] = displacement;
  return 0.0;
}

// dd/dt = v - d/tau.
double MaxwellBehindPlay::depthAfter(double depth, double velocity, double time) const {
  const Relaxation relaxation = Relaxation::over(time / relaxation_time_);
  return relaxation.decay * depth + relaxation.mean * velocity * time;
}

// Contact on the side where it is, then free flight, then contact on the side that the motion goes to.
double MaxwellBehindPlay::offsetAfter(double offset, double velocity, double time) const {
  const double depth = std::abs(offset) - gap_;
  if (depth > 0.0) {
    const double inward = std::copysign(velocity, velocity * offset);  // towards more contact, if positive
    const double lasts = inward < 0.0 ? relaxation_time_ * std::log1p(-depth / (relaxation_time_ * inward)) : time;
    if (lasts >= time) {
      return std::copysign(gap_ + depthAfter(depth, inward, time), offset);
    }
    offset = std::copysign(gap_, offset);
    time -= lasts;
  }
  const double speed = std::abs(velocity);
  const double way = gap_ - std::copysign(offset, velocity * offset);
  if (speed * time <= way) {
    return offset + velocity * time;
  }
  return std::copysign(gap_ + depthAfter(0.0, speed, time - way / speed), velocity);
}

double MaxwellBehindPlay::step(const Motion& motion, double* memory) const {
  const double start = motion.displacement - motion.increment - memory[0];
  const double offset = offsetAfter(start, motion.increment / motion.dt, motion.dt);
  memory[0] = motion.displacement - offset;
  return stiffness_ * (offset - std::clamp(offset, -gap_, gap_));
}

ElementType maxwellBehindPlayType() {
  return {"maxwell_behind_play",
          "Spring and dashpot in series behind a clearance of their own: a damper with backlash.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the spring"},
           {"break_frequency", "Hz", Role::shape, Range::positive(),
            "break frequency f_b; high for a dashpot c = k/(2 pi f_b)"},
           {"gap", "m", Role::shape, Range::positive(), "clearance g to either side"}},
          makes<MaxwellBehindPlay>("stiffness", "break_frequency", "gap")};
}

}  // namespace rubber_suspension::element
