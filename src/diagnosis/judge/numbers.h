// The numbers that the judgement by posterior takes, in one table. All of them are fitted to cases of known cause.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace rubber_suspension::diagnosis::judge {

/// Sizes are root mean squares in units of the standard deviation of the force; a prior is the logarithm of odds.
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
  std::map<std::string, double> rates = {};  ///< by effect, over the rate of a usual one

  /// 0 for effects that no case told anything of.
  double rateOf(const std::string& name) const;
};

/// A row of the table, with what is believed of the number before any case.
struct NumberInfo {
  const char* name;
  const char* meaning;
  const char* unit;
  double JudgeNumbers::* value;
  bool positive;     ///< mean and deviation are of its logarithm, and so is the fit
  double mean;       ///< of the number itself in either case
  double deviation;  ///< standard deviation
};

const std::vector<NumberInfo>& numberTable();

/// Standard deviation of each of `rates` before any case; their mean is 0.
constexpr double kRateDeviation = 0.7;

/// The numbers as fitted last (fitted_numbers.cpp).
const JudgeNumbers& fittedNumbers();

}  // namespace rubber_suspension::diagnosis::judge
