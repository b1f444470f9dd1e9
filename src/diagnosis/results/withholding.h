// The component file leaves no more of any log than the configured component does: what would break that is withheld.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/results/written_law.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::results {

/// The written law of what an answer names, without the effects by which it would leave more of a log than the
/// configured component (leftOfLogs()): those of single logs first, then those without which the others leave least.
/// Without any effect the re-estimated values stand, and without these the configured ones. `named`: the written law
/// of all; `before`: the gap of the re-estimated model; `findings`: what the rig did to each log.
MeasuredLaw withoutDamage(const hypotheses::PreparedCase& prepared, const Workings& workings, MeasuredLaw named,
                          double before, const std::vector<measurement::RigFinding>& findings,
                          const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis::results
