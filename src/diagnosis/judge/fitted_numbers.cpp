// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-27, on 138 cases:
// 8 machine, 2 mixed, 9 none, 17 pair, 31 parameter_error, 59 single, 4 triple, 8 unknown.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::judge {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 11.86;
    fitted.growth = 0.1676;
    fitted.form_error = 0.04882;
    fitted.form_error_of_one = 0.05322;
    fitted.accepted = 0.008326;
    fitted.floor_known = 0.573;
    fitted.tails = 3.957;
    fitted.sheet_scale = 1.388;
    fitted.sheet_tails = 4.542;
    fitted.values_spread = 0.6991;
    fitted.no_effect = 0.6692;
    fitted.common_gain = -1.374;
    fitted.rest = -2.239;
    fitted.effect = -4.605;
    fitted.second = -0.8451;
    fitted.third = -1.019;
    fitted.per_number_beyond = 0.2372;
    fitted.per_trend = 0.4196;
    fitted.per_offset = 0.2796;
    fitted.per_gain = 0.5755;
    fitted.share = 0.8477;
    fitted.share_spread = 0.5684;
    fitted.rates["asymmetric_stiffness"] = -0.618;
    fitted.rates["backlash"] = -0.669;
    fitted.rates["bump_stop"] = -0.454;
    fitted.rates["creep"] = 0.546;
    fitted.rates["fluid_inertia"] = 0.495;
    fitted.rates["force_drift"] = -0.0206;
    fitted.rates["force_offset"] = 0.114;
    fitted.rates["free_play"] = -0.0117;
    fitted.rates["friction"] = 0.512;
    fitted.rates["inertia"] = 0.491;
    fitted.rates["lift_off"] = -0.31;
    fitted.rates["progressive_stiffness"] = 0.619;
    fitted.rates["radial_coupling"] = -5e-06;
    fitted.rates["rate_amplitude_coupling"] = -0.934;
    fitted.rates["relaxation"] = -0.656;
    fitted.rates["self_heating"] = -0.0313;
    fitted.rates["sensor_gain"] = -0.6;
    fitted.rates["series_compliance"] = -0.31;
    fitted.rates["stress_softening"] = 0.295;
    fitted.rates["temperature"] = -5e-06;
    fitted.rates["time_delay"] = 0.206;
    fitted.rates["viscous_damping"] = 0.5;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis::judge
