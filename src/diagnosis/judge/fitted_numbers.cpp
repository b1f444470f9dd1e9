// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-26, on 101 cases (5 machine, 3 mixed, 7 none, 16 pair, 5 parameter_error, 51 single, 3 triple, 11 unknown).
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 8.681;
    fitted.growth = 0.1563;
    fitted.form_error = 0.0504;
    fitted.form_error_on_rig = 0.02463;
    fitted.accepted = 0.006673;
    fitted.floor_known = 0.5919;
    fitted.tails = 3.69;
    fitted.moved_values = 0.3274;
    fitted.no_effect = 0.02267;
    fitted.rest = -2.319;
    fitted.effect = -2.666;
    fitted.second = -1.318;
    fitted.third = -0.8466;
    fitted.per_number = 0.3248;
    fitted.per_trend = 0.1992;
    fitted.per_gain = 0.4362;
    fitted.least_size = 0.1232;
    fitted.size_spread = 0.5704;
    fitted.rates["asymmetric_stiffness"] = -0.553;
    fitted.rates["backlash"] = -0.115;
    fitted.rates["bump_stop"] = -0.227;
    fitted.rates["creep"] = 0.0373;
    fitted.rates["force_drift"] = 0.214;
    fitted.rates["force_offset"] = 0.558;
    fitted.rates["free_play"] = -0.116;
    fitted.rates["friction"] = 0.858;
    fitted.rates["inertia"] = -0.0796;
    fitted.rates["progressive_stiffness"] = 0.715;
    fitted.rates["rate_amplitude_coupling"] = -1.13;
    fitted.rates["relaxation"] = 0.00641;
    fitted.rates["self_heating"] = -0.0237;
    fitted.rates["sensor_gain"] = -0.239;
    fitted.rates["series_compliance"] = -0.258;
    fitted.rates["stress_softening"] = 0.33;
    fitted.rates["temperature"] = -4.99e-06;
    fitted.rates["time_delay"] = -0.095;
    fitted.rates["viscous_damping"] = 0.189;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
