// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-27, on 332 cases:
// 5 machine, 9 mixed, 42 none, 52 pair, 13 parameter_error, 174 single, 14 triple, 23 unknown.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::judge {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 12.43;
    fitted.growth = 0.1054;
    fitted.form_error = 0.02552;
    fitted.form_error_on_rig = 0.02509;
    fitted.accepted = 0.007951;
    fitted.floor_known = 0.5829;
    fitted.tails = 4.001;
    fitted.moved_values = 0.8012;
    fitted.no_effect = 0.8499;
    fitted.rest = -3.314;
    fitted.effect = -4.596;
    fitted.second = -2.006;
    fitted.third = -0.4268;
    fitted.per_number = 0.1327;
    fitted.per_trend = 0.5641;
    fitted.per_gain = 0.6475;
    fitted.least_size = 0.07602;
    fitted.size_spread = 0.7081;
    fitted.rates["asymmetric_stiffness"] = -0.946;
    fitted.rates["backlash"] = -0.444;
    fitted.rates["bump_stop"] = -0.506;
    fitted.rates["creep"] = 0.397;
    fitted.rates["fluid_inertia"] = -0.616;
    fitted.rates["force_drift"] = -0.18;
    fitted.rates["force_offset"] = 0.126;
    fitted.rates["free_play"] = -0.204;
    fitted.rates["friction"] = 1.33;
    fitted.rates["inertia"] = 0.0385;
    fitted.rates["progressive_stiffness"] = 0.972;
    fitted.rates["radial_coupling"] = -5e-06;
    fitted.rates["rate_amplitude_coupling"] = -0.853;
    fitted.rates["relaxation"] = -0.62;
    fitted.rates["self_heating"] = -0.123;
    fitted.rates["sensor_gain"] = -0.292;
    fitted.rates["series_compliance"] = -0.955;
    fitted.rates["stress_softening"] = 1.6;
    fitted.rates["temperature"] = -5e-06;
    fitted.rates["time_delay"] = 0.0982;
    fitted.rates["viscous_damping"] = 0.826;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis::judge
