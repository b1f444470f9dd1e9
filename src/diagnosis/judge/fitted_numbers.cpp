// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-30, beyond_spread alone, on 199 cases:
// 8 machine, 3 mixed, 9 none, 19 pair, 34 parameter_error, 113 single, 4 triple, 9 unknown.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::judge {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 11.06;
    fitted.growth = 0.1712;
    fitted.form_error = 0.06241;
    fitted.form_error_of_one = 0.02291;
    fitted.accepted = 0.006627;
    fitted.floor_known = 0.5829;
    fitted.tails = 4.165;
    fitted.sheet_scale = 1.336;
    fitted.sheet_tails = 4.376;
    fitted.values_spread = 0.7;
    fitted.no_effect = 1.299;
    fitted.common_gain = -1.387;
    fitted.rest = -2.19;
    fitted.effect = -4.577;
    fitted.second = -0.6605;
    fitted.third = -0.9503;
    fitted.per_number_beyond = 0.2284;
    fitted.per_trend = 0.4259;
    fitted.per_offset = 0.3615;
    fitted.per_gain = 0.7894;
    fitted.share = 0.5988;
    fitted.share_spread = 0.6208;
    fitted.beyond_spread = 1.838;
    fitted.rates["asymmetric_stiffness"] = -0.605;
    fitted.rates["backlash"] = -0.589;
    fitted.rates["bump_stop"] = -0.465;
    fitted.rates["creep"] = 0.539;
    fitted.rates["fluid_inertia"] = 0.516;
    fitted.rates["force_drift"] = -0.0272;
    fitted.rates["force_offset"] = 0.0106;
    fitted.rates["free_play"] = -0.0173;
    fitted.rates["friction"] = 0.459;
    fitted.rates["inertia"] = 0.371;
    fitted.rates["lift_off"] = -0.000225;
    fitted.rates["payne_effect"] = 0;
    fitted.rates["progressive_stiffness"] = 0.587;
    fitted.rates["radial_coupling"] = -5.02e-06;
    fitted.rates["rate_amplitude_coupling"] = -1.03;
    fitted.rates["relaxation"] = -0.75;
    fitted.rates["self_heating"] = -0.0466;
    fitted.rates["sensor_gain"] = -0.502;
    fitted.rates["series_compliance"] = -0.277;
    fitted.rates["stress_softening"] = 0.31;
    fitted.rates["temperature"] = -5.02e-06;
    fitted.rates["time_delay"] = 0.345;
    fitted.rates["viscous_damping"] = 0.637;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis::judge
