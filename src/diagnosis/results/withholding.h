// Withholds effects with which the component file would have a larger gap on a log than the configured component.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/results/written_law.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the written law of an answer without effects that make its gap on a log larger than that of the configured
/// component (leftOfLogs()), and without gains and offsets of single logs. Effects of single logs are withheld first,
/// then those without which the excess is least; if none remains, re-estimated or else configured values are written.
/// `named`: the law with all effects; `before`: gap of the re-estimated model; `findings`: errors of the rig.
MeasuredLaw withoutDamage(const hypotheses::PreparedCase& prepared, const Workings& workings, MeasuredLaw named,
                          double before, const std::vector<measurement::RigFinding>& findings,
                          const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis::results
