// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-26, on 99 cases (5 machine, 7 none, 19 pair, 5 parameter_error, 55 single, 2 triple, 6 unknown).
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 7.545;
    fitted.growth = 0.1601;
    fitted.form_error = 0.05564;
    fitted.form_error_on_rig = 0.04744;
    fitted.accepted = 0.007508;
    fitted.floor_known = 0.4567;
    fitted.tails = 3.488;
    fitted.moved_values = 0.5116;
    fitted.no_effect = 1.872;
    fitted.rest = -2.108;
    fitted.effect = -2.426;
    fitted.second = -1.63;
    fitted.third = -0.8031;
    fitted.per_number = 0.3027;
    fitted.per_trend = 0.2566;
    fitted.per_gain = 0.4915;
    fitted.least_size = 0.12;
    fitted.size_spread = 0.5973;
    fitted.rates["asymmetric_stiffness"] = -0.471;
    fitted.rates["backlash"] = -0.0225;
    fitted.rates["bump_stop"] = -0.204;
    fitted.rates["creep"] = -0.0701;
    fitted.rates["fluid_inertia"] = -0.361;
    fitted.rates["force_drift"] = 0.127;
    fitted.rates["force_offset"] = 0.423;
    fitted.rates["free_play"] = -0.0972;
    fitted.rates["friction"] = 0.736;
    fitted.rates["inertia"] = -0.014;
    fitted.rates["progressive_stiffness"] = 0.734;
    fitted.rates["rate_amplitude_coupling"] = -1.26;
    fitted.rates["relaxation"] = -0.14;
    fitted.rates["self_heating"] = -0.0231;
    fitted.rates["sensor_gain"] = -0.201;
    fitted.rates["series_compliance"] = -0.29;
    fitted.rates["stress_softening"] = 0.5;
    fitted.rates["temperature"] = -4.95e-06;
    fitted.rates["time_delay"] = 0.136;
    fitted.rates["viscous_damping"] = 0.619;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
