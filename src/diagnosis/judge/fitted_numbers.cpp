// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-27, on 138 cases:
// 8 machine, 2 mixed, 9 none, 17 pair, 31 parameter_error, 59 single, 4 triple, 8 unknown.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::judge {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 11.73;
    fitted.growth = 0.1671;
    fitted.form_error = 0.05084;
    fitted.form_error_on_rig = 0.0571;
    fitted.accepted = 0.007957;
    fitted.floor_known = 0.5886;
    fitted.tails = 3.983;
    fitted.sheet_scale = 1.396;
    fitted.sheet_tails = 4.57;
    fitted.values_spread = 0.6998;
    fitted.no_effect = 0.7397;
    fitted.common_gain = -1.358;
    fitted.rest = -2.303;
    fitted.effect = -4.601;
    fitted.second = -0.8467;
    fitted.third = -1.021;
    fitted.per_number_beyond = 0.2338;
    fitted.per_trend = 0.4226;
    fitted.per_offset = 0.2846;
    fitted.per_gain = 0.5791;
    fitted.share = 0.8315;
    fitted.share_spread = 0.5743;
    fitted.rates["asymmetric_stiffness"] = -0.615;
    fitted.rates["backlash"] = -0.651;
    fitted.rates["bump_stop"] = -0.456;
    fitted.rates["creep"] = 0.559;
    fitted.rates["fluid_inertia"] = 0.482;
    fitted.rates["force_drift"] = -0.0229;
    fitted.rates["force_offset"] = 0.106;
    fitted.rates["free_play"] = -0.0127;
    fitted.rates["friction"] = 0.501;
    fitted.rates["inertia"] = 0.512;
    fitted.rates["progressive_stiffness"] = 0.609;
    fitted.rates["radial_coupling"] = -5e-06;
    fitted.rates["rate_amplitude_coupling"] = -0.944;
    fitted.rates["relaxation"] = -0.672;
    fitted.rates["self_heating"] = -0.0327;
    fitted.rates["sensor_gain"] = -0.592;
    fitted.rates["series_compliance"] = -0.297;
    fitted.rates["stress_softening"] = 0.297;
    fitted.rates["temperature"] = -5e-06;
    fitted.rates["time_delay"] = 0.209;
    fitted.rates["viscous_damping"] = 0.503;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis::judge
