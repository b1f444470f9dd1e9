// Evidence as text: to judge it again without a simulation.
#pragma once

#include <string>

#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis {

/// Schema rubber_suspension/evidence/4: an object with the members of Evidence under their names. Each of `hypotheses`
/// has its `log_errors` in the order of `logs`, and in `sizes` a list over the logs for each of its members. A number
/// that no model run gives is null.
std::string toJson(const Evidence& evidence);

/// Reads schema 3, too. Throws std::invalid_argument for text that is not such evidence.
Evidence parseEvidence(const std::string& text);

}  // namespace rubber_suspension::diagnosis
