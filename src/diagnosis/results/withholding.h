// Withholds effects with which the component file would have a larger gap on a log than the configured component.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/results/written_law.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the written law of an answer, without effects that make its gap on a log larger than that of the configured
/// component (leftOfLogs()), and without gains and offsets of single logs. Effects with per-log parameters are withheld
/// first, then in each step the effect whose omission leaves the least excess. If no effect remains, the re-estimated
/// values are written, or the configured values if those are too bad as well. `named` is the law with all effects,
/// `before` the gap of the re-estimated model, and `findings` are the errors of the rig.
MeasuredLaw withoutDamage(const hypotheses::PreparedCase& prepared, const Workings& workings, MeasuredLaw named,
                          double before, const std::vector<measurement::RigFinding>& findings,
                          const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis::results
