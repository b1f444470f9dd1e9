// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-26, on 293 cases:
// 5 machine, 9 mixed, 24 none, 49 pair, 11 parameter_error, 162 single, 14 triple, 19 unknown.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 8.286;
    fitted.growth = 0.1361;
    fitted.form_error = 0.03799;
    fitted.form_error_on_rig = 0.03759;
    fitted.accepted = 0.003538;
    fitted.floor_known = 0.3396;
    fitted.tails = 3.861;
    fitted.moved_values = 0.6674;
    fitted.no_effect = 2.581;
    fitted.rest = -1.769;
    fitted.effect = -2.562;
    fitted.second = -1.385;
    fitted.third = -0.5882;
    fitted.per_number = 0.2564;
    fitted.per_trend = 0.3407;
    fitted.per_gain = 0.5459;
    fitted.least_size = 0.1802;
    fitted.size_spread = 0.6065;
    fitted.rates["asymmetric_stiffness"] = -0.665;
    fitted.rates["backlash"] = -0.154;
    fitted.rates["bump_stop"] = -0.107;
    fitted.rates["creep"] = 0.285;
    fitted.rates["fluid_inertia"] = -0.647;
    fitted.rates["force_drift"] = 0.0883;
    fitted.rates["force_offset"] = 0.243;
    fitted.rates["free_play"] = -0.129;
    fitted.rates["friction"] = 0.881;
    fitted.rates["inertia"] = -0.0345;
    fitted.rates["progressive_stiffness"] = 1.01;
    fitted.rates["radial_coupling"] = -4.99e-06;
    fitted.rates["rate_amplitude_coupling"] = -1.43;
    fitted.rates["relaxation"] = -0.431;
    fitted.rates["self_heating"] = -0.0963;
    fitted.rates["sensor_gain"] = -0.211;
    fitted.rates["series_compliance"] = -0.282;
    fitted.rates["stress_softening"] = 1.25;
    fitted.rates["temperature"] = -5e-06;
    fitted.rates["time_delay"] = -0.102;
    fitted.rates["viscous_damping"] = 0.637;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
