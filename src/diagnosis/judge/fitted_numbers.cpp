// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-27, on 127 cases:
// 5 machine, 2 mixed, 9 none, 17 pair, 31 parameter_error, 51 single, 4 triple, 8 unknown.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::judge {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 11.38;
    fitted.growth = 0.1792;
    fitted.form_error = 0.05015;
    fitted.form_error_on_rig = 0.05325;
    fitted.accepted = 0.007601;
    fitted.floor_known = 0.5984;
    fitted.tails = 3.998;
    fitted.sheet_scale = 1.472;
    fitted.sheet_tails = 4.748;
    fitted.values_spread = 0.7;
    fitted.no_effect = 0.8101;
    fitted.common_gain = -1.358;
    fitted.rest = -2.428;
    fitted.effect = -4.52;
    fitted.second = -0.9274;
    fitted.third = -1.027;
    fitted.per_number_beyond = 0.2028;
    fitted.per_trend = 0.4271;
    fitted.per_offset = 0.3156;
    fitted.per_gain = 0.7481;
    fitted.share = 0.7175;
    fitted.share_spread = 0.5987;
    fitted.rates["asymmetric_stiffness"] = -0.598;
    fitted.rates["backlash"] = -0.583;
    fitted.rates["bump_stop"] = -0.262;
    fitted.rates["creep"] = 0.416;
    fitted.rates["fluid_inertia"] = 0.424;
    fitted.rates["force_drift"] = -0.0273;
    fitted.rates["force_offset"] = 0.0896;
    fitted.rates["free_play"] = -0.0204;
    fitted.rates["friction"] = 0.51;
    fitted.rates["inertia"] = 0.509;
    fitted.rates["progressive_stiffness"] = 0.59;
    fitted.rates["radial_coupling"] = -5e-06;
    fitted.rates["rate_amplitude_coupling"] = -1.07;
    fitted.rates["relaxation"] = -0.699;
    fitted.rates["self_heating"] = -0.032;
    fitted.rates["sensor_gain"] = -0.584;
    fitted.rates["series_compliance"] = -0.244;
    fitted.rates["stress_softening"] = 0.329;
    fitted.rates["temperature"] = -5e-06;
    fitted.rates["time_delay"] = 0.166;
    fitted.rates["viscous_damping"] = 0.58;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis::judge
