// Evidence as text: to judge it again with other criteria, without a simulation.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis {

/// Evidence and the names of the effects that it is about, schema rubber_suspension/evidence/3: an object with the
/// members of Evidence under their names. `logs` is the table of the logs, those of the fit first; each of `hypotheses`
/// has its `log_errors` in the same order, and in `sizes` a list over the logs for each of its members. Errors of
/// blocks and logs and sizes are mean squares in units of the force's variance, all others gaps. A number that no model
/// run gives is null.
struct NamedEvidence {
  Evidence evidence;
  std::vector<std::string> effects;
  std::vector<bool> on_rig;  ///< of each effect: it belongs to the rig, not to the rubber
};

std::string toJson(const NamedEvidence& named);

/// Throws std::invalid_argument for text that is not such evidence.
NamedEvidence parseEvidence(const std::string& text);

}  // namespace rubber_suspension::diagnosis
