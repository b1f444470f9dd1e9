// Findings about a rig.
#include "rubber_suspension/measurement/rig_finding.h"

#include <algorithm>

namespace rubber_suspension::measurement {

bool anyFatal(const std::vector<RigFinding>& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const RigFinding& finding) { return finding.fatal; });
}

}  // namespace rubber_suspension::measurement
