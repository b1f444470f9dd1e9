// The component that a diagnosis writes: the simplest law of what it named, rounded; and what it comes to.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/results/replayed.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// Sets the component that a diagnosis writes, the full law of the hypothesis that was judged, their sizes and the gap
/// of the full law; returns the errors of that component. `before`: gap of the re-estimated model.
Replayed addWrittenLaw(const hypotheses::PreparedCase& prepared, const std::vector<fit::Candidate>& candidates,
                       const hypotheses::FittedHypothesis& judged, double before, const DiagnosisOptions& options,
                       Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis::results
