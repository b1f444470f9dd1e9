// The table of the limits of a proposed experiment, and the parser of --limits.
#include "rubber_suspension/diagnosis/experiment_limits.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "io/named_row.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::diagnosis {
const std::vector<ExperimentLimitInfo>& experimentLimitTable() {
  static const std::vector<ExperimentLimitInfo> table = {
      {"stroke", "m", "largest displacement on either side of 0", &ExperimentLimits::stroke},
      {"speed", "m/s", "largest speed of the displacement", &ExperimentLimits::speed},
      {"frequency", "Hz", "highest frequency of a motion", &ExperimentLimits::frequency},
      {"force", "N", "largest force to either side of 0", &ExperimentLimits::force},
      {"duration", "s", "duration of the whole log", &ExperimentLimits::duration},
  };
  return table;
}

void setExperimentLimit(ExperimentLimits& limits, const std::string& assignment) {
  const std::size_t equal = assignment.find('=');
  if (equal == std::string::npos) {
    throw std::invalid_argument(
        fmt::format("{}: '=' is missing; accepted: KEY=VALUE, such as stroke=20 mm", log::quoted(assignment)));
  }
  const std::string key = log::trimmed(assignment.substr(0, equal));
  const ExperimentLimitInfo row = io::namedRow(experimentLimitTable(), key, "not a limit of an experiment");
  const std::string text = log::trimmed(assignment.substr(equal + 1));
  const std::string accepted = fmt::format("a number in {} or text with such a unit, above 0", row.unit);
  double value = 0.0;
  try {
    value = log::parseQuantity(text, row.unit);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("{}: {}: {}; accepted: {}", key, log::quoted(text), error.what(), accepted));
  }
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("{}: {} is out of range; accepted: {}", key, log::quoted(text), accepted));
  }
  limits.*row.member = value;
}

}  // namespace rubber_suspension::diagnosis
