// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-26, on 150 cases (5 machine, 2 mixed, 11 none, 26 pair, 7 parameter_error, 83 single, 6 triple, 10 unknown).
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 4.998;
    fitted.growth = 0.1962;
    fitted.form_error = 0.04277;
    fitted.form_error_on_rig = 0.06045;
    fitted.accepted = 0.003296;
    fitted.floor_known = 0.296;
    fitted.tails = 3.475;
    fitted.moved_values = 0.5412;
    fitted.no_effect = 0.6518;
    fitted.rest = -3.295;
    fitted.effect = -2.144;
    fitted.second = -1.932;
    fitted.third = -0.9955;
    fitted.per_number = 0.3059;
    fitted.per_trend = 0.385;
    fitted.per_gain = 0.5478;
    fitted.least_size = 0.1381;
    fitted.size_spread = 0.5683;
    fitted.rates["asymmetric_stiffness"] = -0.534;
    fitted.rates["backlash"] = 0.094;
    fitted.rates["bump_stop"] = -0.287;
    fitted.rates["creep"] = 0.0805;
    fitted.rates["fluid_inertia"] = -0.576;
    fitted.rates["force_drift"] = -0.161;
    fitted.rates["force_offset"] = 0.732;
    fitted.rates["free_play"] = 0.00982;
    fitted.rates["friction"] = 0.794;
    fitted.rates["inertia"] = -0.0204;
    fitted.rates["progressive_stiffness"] = 1.06;
    fitted.rates["rate_amplitude_coupling"] = -1.44;
    fitted.rates["relaxation"] = -0.309;
    fitted.rates["self_heating"] = -0.037;
    fitted.rates["sensor_gain"] = -0.346;
    fitted.rates["series_compliance"] = 0.0153;
    fitted.rates["stress_softening"] = 0.611;
    fitted.rates["temperature"] = -5e-06;
    fitted.rates["time_delay"] = -0.162;
    fitted.rates["viscous_damping"] = 0.666;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
