// Returns parts of the report for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/could_show.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::report {

/// Returns the effects that logs could have shown. Sizes are divided by the standard deviation of the force. A size is
/// null if even an effect as large as the force would not be found.
nlohmann::ordered_json toJson(const CouldShow& could_show);

/// Returns the findings about the rig, each with its meaning, remedy and certainty.
std::vector<nlohmann::ordered_json> findingsJson(const std::vector<measurement::RigFinding>& findings);

/// The meaning of a finding about the rig, and how to mend it at the bench.
struct FindingAdvice {
  std::string meaning;
  std::string remedy;
};

/// Returns the advice on a finding with this name in reports. The texts are empty if there is no advice.
const FindingAdvice& adviceOn(const std::string& finding);

}  // namespace rubber_suspension::diagnosis::report
