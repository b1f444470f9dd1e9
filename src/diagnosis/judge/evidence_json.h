// Evidence as text. The program judge_again (test/blind_trial) judges this text without a simulation.
#pragma once

#include <string>

#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis::judge {

/// Returns evidence as JSON text, schema rubber_suspension/evidence/11. The text is an object that contains the data
/// members of Evidence under their names. In each hypothesis, `log_errors` is in the order of `logs`, and `sizes`
/// contains a list over the logs for each effect. Numbers that are not finite are null.
std::string toJson(const Evidence& evidence);

}  // namespace rubber_suspension::diagnosis::judge
