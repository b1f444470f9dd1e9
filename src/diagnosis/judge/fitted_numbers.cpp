// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-26, on 42 cases (5 machine, 1 mixed, 3 none, 6 pair, 2 parameter_error, 20 single, 2 triple, 3 unknown).
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 9.052;
    fitted.growth = 0.188;
    fitted.form_error = 0.07428;
    fitted.form_error_on_rig = 0.03295;
    fitted.accepted = 0.005145;
    fitted.floor_known = 0.4648;
    fitted.tails = 3.758;
    fitted.moved_values = 0.5747;
    fitted.none = 1.5;
    fitted.wrong_values = 1.038;
    fitted.rest = -1.567;
    fitted.effect = -3.865;
    fitted.second = -1.894;
    fitted.third = -0.5701;
    fitted.per_number = 0.2526;
    fitted.per_trend = 0.5826;
    fitted.per_gain = 0.4359;
    fitted.least_size = 0.06307;
    fitted.size_spread = 0.5688;
    fitted.rates["asymmetric_stiffness"] = -0.418;
    fitted.rates["backlash"] = -0.179;
    fitted.rates["bump_stop"] = -0.154;
    fitted.rates["creep"] = 0.252;
    fitted.rates["force_drift"] = -0.257;
    fitted.rates["force_offset"] = 0.0867;
    fitted.rates["free_play"] = -0.00965;
    fitted.rates["friction"] = 0.68;
    fitted.rates["inertia"] = -0.00322;
    fitted.rates["progressive_stiffness"] = 0.593;
    fitted.rates["rate_amplitude_coupling"] = -0.61;
    fitted.rates["relaxation"] = 0.0559;
    fitted.rates["self_heating"] = -0.0123;
    fitted.rates["sensor_gain"] = -0.0695;
    fitted.rates["series_compliance"] = -0.131;
    fitted.rates["stress_softening"] = 0.146;
    fitted.rates["temperature"] = -5e-06;
    fitted.rates["time_delay"] = -0.107;
    fitted.rates["viscous_damping"] = -0.0507;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
