// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-26, on 148 cases (5 machine, 2 mixed, 11 none, 26 pair, 7 parameter_error, 81 single, 6 triple, 10 unknown).
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 4.519;
    fitted.growth = 0.1849;
    fitted.form_error = 0.04374;
    fitted.form_error_on_rig = 0.05517;
    fitted.accepted = 0.004548;
    fitted.floor_known = 0.275;
    fitted.tails = 3.061;
    fitted.moved_values = 0.5483;
    fitted.no_effect = -0.1072;
    fitted.rest = -3.936;
    fitted.effect = -2.331;
    fitted.second = -1.756;
    fitted.third = -0.8927;
    fitted.per_number = 0.3085;
    fitted.per_trend = 0.376;
    fitted.per_gain = 0.553;
    fitted.least_size = 0.1275;
    fitted.size_spread = 0.6361;
    fitted.rates["asymmetric_stiffness"] = -0.501;
    fitted.rates["backlash"] = 0.0252;
    fitted.rates["bump_stop"] = -0.307;
    fitted.rates["creep"] = 0.0671;
    fitted.rates["fluid_inertia"] = -0.558;
    fitted.rates["force_drift"] = -0.139;
    fitted.rates["force_offset"] = 0.652;
    fitted.rates["free_play"] = 0.0606;
    fitted.rates["friction"] = 0.814;
    fitted.rates["inertia"] = -0.0227;
    fitted.rates["progressive_stiffness"] = 1.04;
    fitted.rates["rate_amplitude_coupling"] = -1.44;
    fitted.rates["relaxation"] = -0.339;
    fitted.rates["self_heating"] = -0.0474;
    fitted.rates["sensor_gain"] = -0.385;
    fitted.rates["series_compliance"] = -0.0758;
    fitted.rates["stress_softening"] = 0.665;
    fitted.rates["temperature"] = -4.99e-06;
    fitted.rates["time_delay"] = -0.104;
    fitted.rates["viscous_damping"] = 0.744;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
