// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-27, on 332 cases:
// 5 machine, 9 mixed, 42 none, 52 pair, 13 parameter_error, 174 single, 14 triple, 23 unknown.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::judge {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 11.98;
    fitted.growth = 0.1041;
    fitted.form_error = 0.02555;
    fitted.form_error_on_rig = 0.02335;
    fitted.accepted = 0.008119;
    fitted.floor_known = 0.5626;
    fitted.tails = 3.79;
    fitted.sheet_scale = 1.0;
    fitted.sheet_tails = 4.0;
    fitted.values_spread = 0.6295;
    fitted.no_effect = 0.559;
    fitted.rest = -3.099;
    fitted.effect = -4.52;
    fitted.second = -2.011;
    fitted.third = -0.3519;
    fitted.per_trend = 0.566;
    fitted.per_gain = 0.6392;
    fitted.share = 0.5;
    fitted.share_spread = 0.6295;
    fitted.rates["asymmetric_stiffness"] = -0.94;
    fitted.rates["backlash"] = -0.469;
    fitted.rates["bump_stop"] = -0.536;
    fitted.rates["creep"] = 0.607;
    fitted.rates["fluid_inertia"] = -0.649;
    fitted.rates["force_drift"] = -0.178;
    fitted.rates["force_offset"] = 0.15;
    fitted.rates["free_play"] = -0.203;
    fitted.rates["friction"] = 1.31;
    fitted.rates["inertia"] = 0.0388;
    fitted.rates["progressive_stiffness"] = 0.966;
    fitted.rates["radial_coupling"] = -5e-06;
    fitted.rates["rate_amplitude_coupling"] = -0.883;
    fitted.rates["relaxation"] = -0.613;
    fitted.rates["self_heating"] = -0.139;
    fitted.rates["sensor_gain"] = -0.309;
    fitted.rates["series_compliance"] = -0.969;
    fitted.rates["stress_softening"] = 1.63;
    fitted.rates["temperature"] = -5e-06;
    fitted.rates["time_delay"] = 0.033;
    fitted.rates["viscous_damping"] = 0.809;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis::judge
