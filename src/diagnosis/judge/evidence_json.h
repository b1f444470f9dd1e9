// Evidence as text, which judge_again (test/blind_trial) judges again without a simulation.
#pragma once

#include <string>

#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis::judge {

/// Schema rubber_suspension/evidence/11: an object with the members of Evidence under their names. Each of `hypotheses`
/// has its `log_errors` in the order of `logs`, and in `sizes` a list over the logs for each of its members. A number
/// that no model run gives is null.
std::string toJson(const Evidence& evidence);

}  // namespace rubber_suspension::diagnosis::judge
