// Evidence as text, which judge_again (test/blind_trial) judges again without a simulation.
#pragma once

#include <string>

#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis::judge {

/// Returns evidence as JSON text, schema rubber_suspension/evidence/11: an object with the members of Evidence under
/// their names. In each hypothesis `log_errors` is in the order of `logs`, and `sizes` has a list over the logs for
/// each member. Numbers that are not finite are null.
std::string toJson(const Evidence& evidence);

}  // namespace rubber_suspension::diagnosis::judge
