// The table of numbers.
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::judge {

double JudgeNumbers::rateOf(const std::string& name) const {
  const auto found = rates.find(name);
  return found == rates.end() ? 0.0 : found->second;
}

const std::vector<NumberInfo>& numberTable() {
  using N = JudgeNumbers;
  static const std::vector<NumberInfo> table = {
      {"sharpness", "by how much the score outweighs the prior, over 50 independent blocks", "1", &N::sharpness, true,
       8.0, 0.6},
      {"growth", "power of the number of blocks by which the sharpness grows", "1", &N::growth, true, 0.2, 0.7},
      {"form_error", "by which share of its own force a law differs from the rubber", "of the member's force",
       &N::form_error, true, 0.12, 0.5},
      {"form_error_of_one", "the same of effects whose law has one form: mass, delay, gain", "of the member's force",
       &N::form_error_of_one, true, 0.025, 0.7},
      {"accepted", "size that discretisation leaves and an engineer accepts", "of the force", &N::accepted, true, 0.008,
       0.5},
      {"floor_known", "by which share of itself the noise floor may be too low", "of the floor", &N::floor_known, true,
       0.5, 0.5},
      {"tails", "degrees of freedom of what is left: few make outliers usual", "1", &N::tails, true, 4.0, 0.4},
      {"sheet_scale", "by how many of their tolerances the numbers of data sheets are off", "1", &N::sheet_scale, true,
       1.0, 0.5},
      {"sheet_tails", "degrees of freedom of these: few make sheets that are far off usual", "1", &N::sheet_tails, true,
       4.0, 0.5},
      {"values_spread", "standard deviation of the logarithm of what wrong values remove, below what is accepted", "1",
       &N::values_spread, true, 0.7, 0.4},
      {"no_effect", "prior of a model without an effect, whether its values are right or wrong", "ln odds",
       &N::no_effect, false, 1.5, 1.5},
      {"common_gain", "prior of one gain of the force's channel on all logs, over that of wrong values", "ln odds",
       &N::common_gain, false, -1.0, 1.0},
      {"rest", "prior of a rest that no listed effect causes", "ln odds", &N::rest, false, -2.0, 1.5},
      {"effect", "prior of each effect of a set", "ln odds", &N::effect, false, -3.0, 1.5},
      {"second", "prior of a second effect, besides", "ln odds", &N::second, false, -1.0, 1.0},
      {"third", "prior of a third effect, besides", "ln odds", &N::third, false, -1.0, 1.0},
      {"per_number_beyond",
       "cost of each number that a law has beyond those that it contains, over half the logarithm of the blocks", "1",
       &N::per_number_beyond, true, 0.2, 0.7},
      {"per_trend", "cost of a trend of its own for a log", "ln odds", &N::per_trend, false, 0.4, 0.3},
      {"per_offset", "cost of a zero of the force of its own for a log", "ln odds", &N::per_offset, false, 0.4, 0.3},
      {"per_gain", "cost of a gain, or of a factor on friction, of its own for a log", "ln odds", &N::per_gain, false,
       0.4, 0.3},
      {"share", "share of what values leave, below which an effect is improbable", "of the gap that values leave",
       &N::share, true, 0.5, 0.5},
      {"share_spread", "standard deviation of the logarithm of the shares below it", "1", &N::share_spread, true, 0.7,
       0.4},
  };
  return table;
}

}  // namespace rubber_suspension::diagnosis::judge
