// The table that describes the numbers of the judgement.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::judge {

double JudgeNumbers::rateOf(const std::string& name) const {
  const auto found = rates.find(name);
  return found == rates.end() ? 0.0 : found->second;
}

const std::vector<NumberInfo>& numberTable() {
  using N = JudgeNumbers;
  static const std::vector<NumberInfo> table = {
      {"sharpness", "weight of the score relative to the prior, for 50 independent blocks", "1", &N::sharpness, true,
       8.0, 0.6},
      {"growth", "exponent with which the sharpness grows with the number of blocks", "1", &N::growth, true, 0.2, 0.7},
      {"form_error", "difference between law and rubber, as a share of the law's force", "of the law's force",
       &N::form_error, true, 0.12, 0.5},
      {"form_error_of_one", "form_error of effects whose law has only one form: mass, delay, gain",
       "of the law's force", &N::form_error_of_one, true, 0.025, 0.7},
      {"accepted", "gap that discretisation causes and an engineer accepts", "of the force", &N::accepted, true, 0.008,
       0.5},
      {"floor_known", "share by which the estimated noise floor may be too low", "of the floor", &N::floor_known, true,
       0.5, 0.5},
      {"tails", "degrees of freedom of the residuals: with few of them, outliers are likely", "1", &N::tails, true, 4.0,
       0.4},
      {"sheet_scale", "error of the numbers of data sheets, in tolerances", "1", &N::sheet_scale, true, 1.0, 0.5},
      {"sheet_tails", "degrees of freedom of sheet_scale: with few of them, large errors are likely", "1",
       &N::sheet_tails, true, 4.0, 0.5},
      {"values_spread", "standard deviation of the logarithm of the gap that wrong values cause, below `accepted`", "1",
       &N::values_spread, true, 0.7, 0.4},
      {"no_effect", "prior of a model without an effect, whether its values are right or wrong", "ln odds",
       &N::no_effect, false, 1.5, 1.5},
      {"common_gain", "prior of one gain of the force channel on all logs, relative to the prior of wrong values",
       "ln odds", &N::common_gain, false, -1.0, 1.0},
      {"rest", "prior of a residual that no listed effect causes", "ln odds", &N::rest, false, -2.0, 1.5},
      {"effect", "prior of each effect of a set", "ln odds", &N::effect, false, -3.0, 1.5},
      {"second", "additional prior of a second effect", "ln odds", &N::second, false, -1.0, 1.0},
      {"third", "additional prior of a third effect", "ln odds", &N::third, false, -1.0, 1.0},
      {"per_number_beyond",
       "cost of each number that a law has in addition to the simpler law that it contains, in half logarithms of the "
       "number of blocks",
       "1", &N::per_number_beyond, true, 0.2, 0.7},
      {"per_trend", "cost of a separate drift of the force in a log", "ln odds", &N::per_trend, true, 0.4, 0.7},
      {"per_offset", "cost of a separate zero error of the force in a log", "ln odds", &N::per_offset, true, 0.4, 0.7},
      {"per_gain", "cost of a separate gain, or factor on friction, in a log", "ln odds", &N::per_gain, true, 0.4, 0.7},
      {"share", "share of the gap after re-estimation below which an effect is improbable",
       "of the gap after re-estimation", &N::share, true, 0.5, 0.5},
      {"share_spread", "standard deviation of the logarithm of smaller shares", "1", &N::share_spread, true, 0.7, 0.4},
      {"beyond_spread", "share_spread of what a law removes beyond the simpler law that it contains", "1",
       &N::beyond_spread, true, 1.5, 0.5},
  };
  return table;
}

}  // namespace rubber_suspension::diagnosis::judge
