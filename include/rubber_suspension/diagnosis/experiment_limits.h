// Limits of a machine in an experiment that a diagnosis proposes.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubber_suspension::diagnosis {

/// Limits of a proposed experiment. By default they are what the logs reached.
struct ExperimentLimits {
  std::optional<double> stroke;     ///< largest displacement to either side of 0 [m]
  std::optional<double> speed;      ///< largest rate of the displacement [m/s]
  std::optional<double> frequency;  ///< highest of a motion [Hz]
  std::optional<double> force;      ///< largest force to either side of 0 [N]
  std::optional<double> duration;   ///< of the whole log [s]
};

/// One row of the table that option and reference page follow.
struct ExperimentLimitInfo {
  std::string name;  ///< the key in `--limits KEY=VALUE`
  std::string unit;  ///< SI
  std::string documentation;
  std::optional<double> ExperimentLimits::* member;
};

const std::vector<ExperimentLimitInfo>& experimentLimitTable();

/// Applies `--limits KEY=VALUE`, such as "stroke=20 mm". Throws std::invalid_argument that names key, value and what is
/// accepted.
void setExperimentLimit(ExperimentLimits& limits, const std::string& assignment);

}  // namespace rubber_suspension::diagnosis
