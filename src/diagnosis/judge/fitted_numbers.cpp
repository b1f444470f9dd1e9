// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-26, on 101 cases (5 machine, 3 mixed, 7 none, 16 pair, 5 parameter_error, 51 single, 3 triple, 11 unknown).
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 8.794;
    fitted.growth = 0.1544;
    fitted.form_error = 0.0496;
    fitted.form_error_on_rig = 0.02224;
    fitted.accepted = 0.005699;
    fitted.floor_known = 0.6117;
    fitted.tails = 3.698;
    fitted.moved_values = 0.333;
    fitted.none = -1.209;
    fitted.wrong_values = 1.581;
    fitted.rest = -1.964;
    fitted.effect = -2.686;
    fitted.second = -1.417;
    fitted.third = -0.9017;
    fitted.per_number = 0.3318;
    fitted.per_trend = 0.2083;
    fitted.per_gain = 0.4288;
    fitted.least_size = 0.1139;
    fitted.size_spread = 0.5547;
    fitted.rates["asymmetric_stiffness"] = -0.575;
    fitted.rates["backlash"] = -0.117;
    fitted.rates["bump_stop"] = -0.248;
    fitted.rates["creep"] = 0.00982;
    fitted.rates["force_drift"] = 0.203;
    fitted.rates["force_offset"] = 0.591;
    fitted.rates["free_play"] = -0.121;
    fitted.rates["friction"] = 0.831;
    fitted.rates["inertia"] = -0.0931;
    fitted.rates["progressive_stiffness"] = 0.707;
    fitted.rates["rate_amplitude_coupling"] = -1.11;
    fitted.rates["relaxation"] = -0.000277;
    fitted.rates["self_heating"] = -0.0312;
    fitted.rates["sensor_gain"] = -0.195;
    fitted.rates["series_compliance"] = -0.203;
    fitted.rates["stress_softening"] = 0.317;
    fitted.rates["temperature"] = -4.99e-06;
    fitted.rates["time_delay"] = -0.0361;
    fitted.rates["viscous_damping"] = 0.14;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
