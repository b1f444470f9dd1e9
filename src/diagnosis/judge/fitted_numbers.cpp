// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-26, on 101 cases (5 machine, 7 none, 19 pair, 5 parameter_error, 56 single, 3 triple, 6 unknown).
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 10.08;
    fitted.growth = 0.1479;
    fitted.form_error = 0.03715;
    fitted.form_error_on_rig = 0.02471;
    fitted.accepted = 0.004984;
    fitted.floor_known = 0.4114;
    fitted.tails = 3.884;
    fitted.moved_values = 0.5448;
    fitted.no_effect = 2.057;
    fitted.rest = -1.296;
    fitted.effect = -3.22;
    fitted.second = -1.316;
    fitted.third = -0.9044;
    fitted.per_number = 0.31;
    fitted.per_trend = 0.4601;
    fitted.per_gain = 0.4778;
    fitted.least_size = 0.1275;
    fitted.size_spread = 0.4538;
    fitted.rates["asymmetric_stiffness"] = -0.484;
    fitted.rates["backlash"] = 0.156;
    fitted.rates["bump_stop"] = -0.188;
    fitted.rates["creep"] = -0.0759;
    fitted.rates["fluid_inertia"] = -0.371;
    fitted.rates["force_drift"] = -0.0682;
    fitted.rates["force_offset"] = 0.0511;
    fitted.rates["free_play"] = -0.0617;
    fitted.rates["friction"] = 0.724;
    fitted.rates["inertia"] = -0.00604;
    fitted.rates["progressive_stiffness"] = 0.739;
    fitted.rates["rate_amplitude_coupling"] = -1.31;
    fitted.rates["relaxation"] = 0.0473;
    fitted.rates["self_heating"] = -0.000864;
    fitted.rates["sensor_gain"] = -0.07;
    fitted.rates["series_compliance"] = -0.048;
    fitted.rates["stress_softening"] = 0.293;
    fitted.rates["temperature"] = -5e-06;
    fitted.rates["time_delay"] = 0.117;
    fitted.rates["viscous_damping"] = 0.497;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
