// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-26, on 101 cases (5 machine, 3 mixed, 7 none, 16 pair, 5 parameter_error, 51 single, 3 triple, 11 unknown).
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 9.536;
    fitted.growth = 0.1465;
    fitted.form_error = 0.04887;
    fitted.form_error_on_rig = 0.02112;
    fitted.accepted = 0.00554;
    fitted.floor_known = 0.5733;
    fitted.tails = 3.624;
    fitted.moved_values = 0.452;
    fitted.none = 0.3856;
    fitted.wrong_values = 2.354;
    fitted.rest = -1.719;
    fitted.effect = -3.175;
    fitted.second = -1.393;
    fitted.third = -0.8389;
    fitted.per_number = 0.3403;
    fitted.per_trend = 0.1995;
    fitted.per_gain = 0.4221;
    fitted.least_size = 0.1065;
    fitted.size_spread = 0.5805;
    fitted.rates["asymmetric_stiffness"] = -0.584;
    fitted.rates["backlash"] = -0.0521;
    fitted.rates["bump_stop"] = -0.268;
    fitted.rates["creep"] = -0.168;
    fitted.rates["force_drift"] = 0.216;
    fitted.rates["force_offset"] = 0.463;
    fitted.rates["free_play"] = -0.0771;
    fitted.rates["friction"] = 0.845;
    fitted.rates["inertia"] = -0.0782;
    fitted.rates["progressive_stiffness"] = 0.657;
    fitted.rates["rate_amplitude_coupling"] = -1.1;
    fitted.rates["relaxation"] = -0.118;
    fitted.rates["self_heating"] = -0.0187;
    fitted.rates["sensor_gain"] = -0.138;
    fitted.rates["series_compliance"] = -0.132;
    fitted.rates["stress_softening"] = 0.38;
    fitted.rates["temperature"] = -4.99e-06;
    fitted.rates["time_delay"] = 0.000748;
    fitted.rates["viscous_damping"] = 0.137;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis
