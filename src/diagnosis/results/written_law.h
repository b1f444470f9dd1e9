// The component that a diagnosis writes: the simplest law of what it named, rounded; and what it comes to.
#pragma once

#include <vector>

#include "diagnosis/results/sizes.h"
#include "diagnosis/results/workings.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {

struct WrittenLaw {
  io::ComponentDescription component;  ///< rounded, as its file reads back
  io::ComponentDescription full;       ///< the law as judged, with all its numbers in full
  std::vector<gap::PartError> errors;  ///< of the rounded one, on the logs held out, or else on held-out blocks
  double full_gap = 0.0;               ///< of the full law, on the same
  Sizes sizes;                         ///< of the simplest law, in full
  int finer = 0;                       ///< digits that rounding takes beyond a tenth of half an interval
};

/// Of the hypothesis that was judged. `before`: gap of the re-estimated model.
WrittenLaw writtenLaw(const PreparedCase& prepared, const std::vector<fit::Candidate>& candidates,
                      const FittedHypothesis& judged, double before, const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis
