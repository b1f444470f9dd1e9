// The numbers of the judgement, all of which are fitted to cases of known cause.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace rubber_suspension::diagnosis::judge {

/// Values of the numbers; numberTable() describes each. Sizes are root mean squares divided by the standard deviation
/// of the force, and a prior is a logarithm of odds.
struct JudgeNumbers {
  double sharpness = 8.0;
  double growth = 0.2;
  double form_error = 0.12;
  double form_error_of_one = 0.025;
  double accepted = 0.008;
  double floor_known = 0.5;
  double tails = 4.0;
  double sheet_scale = 1.0;
  double sheet_tails = 4.0;
  double values_spread = 0.7;
  double no_effect = 1.5;
  double common_gain = -1.0;
  double rest = -2.0;
  double effect = -3.0;
  double second = -1.0;
  double third = -1.0;
  double per_number_beyond = 0.2;
  double per_trend = 0.4;
  double per_offset = 0.4;
  double per_gain = 0.4;
  double share = 0.5;
  double share_spread = 0.7;
  double beyond_spread = 1.5;
  /// for each effect: addition to the log prior that all effects have in common
  std::map<std::string, double> rates = {};

  /// Returns the entry of `rates` for an effect, or 0 if there is none.
  double rateOf(const std::string& name) const;
};

/// Description of one number, with the prior distribution from which it is fitted.
struct NumberInfo {
  const char* name;
  const char* meaning;
  const char* unit;
  double JudgeNumbers::* value;
  bool positive;     ///< the logarithm of the number is fitted and has a normal prior
  double mean;       ///< mean of the prior; if `positive`, the exponential of the mean of the logarithm
  double deviation;  ///< standard deviation of the prior; if `positive`, of the prior of the logarithm
};

const std::vector<NumberInfo>& numberTable();

/// Standard deviation of the normal prior of each entry of `rates`. The mean of this prior is 0.
constexpr double kRateDeviation = 0.7;

/// Returns the numbers of the last fit (fitted_numbers.cpp).
const JudgeNumbers& fittedNumbers();

}  // namespace rubber_suspension::diagnosis::judge
