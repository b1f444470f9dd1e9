// The parts of a report for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/could_show.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::report {

/// Effects that logs could have shown. Sizes as shares of the force's standard deviation; a size that no effect of all
/// of the force reaches is null.
nlohmann::ordered_json toJson(const CouldShow& could_show);

/// Findings about the rig, each with its meaning, remedy and certainty.
std::vector<nlohmann::ordered_json> findingsJson(const std::vector<measurement::RigFinding>& findings);

/// The meaning of a finding about the rig, and how to mend it at the bench.
struct FindingAdvice {
  std::string meaning;
  std::string remedy;
};

/// By the name that reports write. Of a name without an entry both are empty: the finding's own text says it.
const FindingAdvice& adviceOn(const std::string& finding);

}  // namespace rubber_suspension::diagnosis::report
