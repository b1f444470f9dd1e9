// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-26, on 101 cases:
// 5 machine, 7 none, 19 pair, 5 parameter_error, 56 single, 3 triple, 6 unknown.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 7.559;
    fitted.growth = 0.1601;
    fitted.form_error = 0.05337;
    fitted.form_error_on_rig = 0.04744;
    fitted.accepted = 0.007259;
    fitted.floor_known = 0.4623;
    fitted.tails = 3.476;
    fitted.moved_values = 0.5061;
    fitted.no_effect = 1.763;
    fitted.rest = -2.156;
    fitted.effect = -2.398;
    fitted.second = -1.687;
    fitted.third = -0.827;
    fitted.per_number = 0.3039;
    fitted.per_trend = 0.2563;
    fitted.per_gain = 0.4907;
    fitted.least_size = 0.1226;
    fitted.size_spread = 0.5873;
    fitted.rates["asymmetric_stiffness"] = -0.47;
    fitted.rates["backlash"] = -0.00515;
    fitted.rates["bump_stop"] = -0.207;
    fitted.rates["creep"] = -0.00891;
    fitted.rates["fluid_inertia"] = -0.421;
    fitted.rates["force_drift"] = 0.129;
    fitted.rates["force_offset"] = 0.411;
    fitted.rates["free_play"] = -0.0946;
    fitted.rates["friction"] = 0.736;
    fitted.rates["inertia"] = -0.0129;
    fitted.rates["progressive_stiffness"] = 0.739;
    fitted.rates["rate_amplitude_coupling"] = -1.28;
    fitted.rates["relaxation"] = -0.173;
    fitted.rates["self_heating"] = -0.0223;
    fitted.rates["sensor_gain"] = -0.203;
    fitted.rates["series_compliance"] = -0.274;
    fitted.rates["stress_softening"] = 0.468;
    fitted.rates["temperature"] = -5e-06;
    fitted.rates["time_delay"] = 0.154;
    fitted.rates["viscous_damping"] = 0.665;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
