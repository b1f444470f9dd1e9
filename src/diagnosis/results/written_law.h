// The component that a diagnosis writes: the simplest law of what it named, rounded; and what it comes to.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {

/// What the component that is written comes to.
struct WrittenLaw {
  std::vector<gap::PartError> errors;  ///< on the logs held out, or else on held-out blocks
  gap::Forces forces;                  ///< that these are errors of [N]: of the logs of the fit, then of those held out
};

/// Sets the component that a diagnosis writes, the full law of the hypothesis that was judged, their sizes and the gap
/// of the full law. `before`: gap of the re-estimated model.
WrittenLaw addWrittenLaw(const hypotheses::PreparedCase& prepared, const std::vector<fit::Candidate>& candidates,
                         const hypotheses::FittedHypothesis& judged, double before, const DiagnosisOptions& options,
                         Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis::results
