// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:
// 2026-11-28, on 138 cases:
// 8 machine, 2 mixed, 9 none, 17 pair, 31 parameter_error, 59 single, 4 triple, 8 unknown.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::judge {

const JudgeNumbers& fittedNumbers() {
  static const JudgeNumbers numbers = [] {
    JudgeNumbers fitted;
    fitted.sharpness = 11.06;
    fitted.growth = 0.1712;
    fitted.form_error = 0.06241;
    fitted.form_error_of_one = 0.02291;
    fitted.accepted = 0.006627;
    fitted.floor_known = 0.5829;
    fitted.tails = 4.165;
    fitted.sheet_scale = 1.336;
    fitted.sheet_tails = 4.376;
    fitted.values_spread = 0.7;
    fitted.no_effect = 1.299;
    fitted.common_gain = -1.387;
    fitted.rest = -2.19;
    fitted.effect = -4.577;
    fitted.second = -0.6605;
    fitted.third = -0.9503;
    fitted.per_number_beyond = 0.2284;
    fitted.per_trend = 0.4259;
    fitted.per_offset = 0.3615;
    fitted.per_gain = 0.7894;
    fitted.share = 0.5988;
    fitted.share_spread = 0.6208;
    fitted.beyond_spread = 0.6208;
    return fitted;
  }();
  return numbers;
}

}  // namespace rubber_suspension::diagnosis::judge
