// Limits of the test machine for an experiment that a diagnosis proposes.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubber_suspension::diagnosis {

/// Limits of a proposed experiment. A limit that is not set defaults to the largest value in the logs.
struct ExperimentLimits {
  std::optional<double> stroke;     ///< largest displacement to either side of 0 [m]
  std::optional<double> speed;      ///< largest rate of the displacement [m/s]
  std::optional<double> frequency;  ///< highest frequency of a motion [Hz]
  std::optional<double> force;      ///< largest force to either side of 0 [N]
  std::optional<double> duration;   ///< duration of the whole log [s]
};

/// A row of the table from which the option `--limits` and its reference page are generated.
struct ExperimentLimitInfo {
  std::string name;  ///< the key in `--limits KEY=VALUE`
  std::string unit;  ///< SI
  std::string documentation;
  std::optional<double> ExperimentLimits::* member;
};

const std::vector<ExperimentLimitInfo>& experimentLimitTable();

/// Sets the limit in an assignment KEY=VALUE, such as "stroke=20 mm". Throws std::invalid_argument for other text.
void setExperimentLimit(ExperimentLimits& limits, const std::string& assignment);

}  // namespace rubber_suspension::diagnosis
