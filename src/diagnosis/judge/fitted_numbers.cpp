// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-26, on 101 cases (5 machine, 3 mixed, 7 none, 16 pair, 5 parameter_error, 51 single, 3 triple, 11 unknown).
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 9.047;
    fitted.growth = 0.1524;
    fitted.form_error = 0.04807;
    fitted.form_error_on_rig = 0.02314;
    fitted.accepted = 0.007042;
    fitted.floor_known = 0.5849;
    fitted.tails = 3.503;
    fitted.moved_values = 0.3417;
    fitted.none = -0.6788;
    fitted.wrong_values = 2.228;
    fitted.rest = -2.241;
    fitted.effect = -2.947;
    fitted.second = -1.372;
    fitted.third = -0.846;
    fitted.per_number = 0.3178;
    fitted.per_trend = 0.2269;
    fitted.per_gain = 0.4271;
    fitted.least_size = 0.1007;
    fitted.size_spread = 0.6209;
    fitted.rates["asymmetric_stiffness"] = -0.579;
    fitted.rates["backlash"] = -0.112;
    fitted.rates["bump_stop"] = -0.278;
    fitted.rates["creep"] = 0.0874;
    fitted.rates["force_drift"] = 0.186;
    fitted.rates["force_offset"] = 0.499;
    fitted.rates["free_play"] = -0.113;
    fitted.rates["friction"] = 0.847;
    fitted.rates["inertia"] = -0.081;
    fitted.rates["progressive_stiffness"] = 0.668;
    fitted.rates["rate_amplitude_coupling"] = -1.11;
    fitted.rates["relaxation"] = 0.0125;
    fitted.rates["self_heating"] = -0.0322;
    fitted.rates["sensor_gain"] = -0.286;
    fitted.rates["series_compliance"] = -0.259;
    fitted.rates["stress_softening"] = 0.415;
    fitted.rates["temperature"] = -4.99e-06;
    fitted.rates["time_delay"] = -0.0387;
    fitted.rates["viscous_damping"] = 0.188;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
