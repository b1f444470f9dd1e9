// How large the named effects and the model's parameters are, with what the logs leave open.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/hypothesis_fitter.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

struct Sizes {
  std::vector<SizedValue> model;    ///< numbers of the specification, or of the elements where there is none
  std::vector<SizedValue> effects;  ///< headline numbers of each member of the hypothesis, in their order
};

/// Sizes of a fitted hypothesis. Intervals are percentiles over resampled blocks of the logs: each resample moves the
/// fit by one step of its own normal equations, within the bounds of the fit.
Sizes sizesOf(const fit::HypothesisFitter& fitter, const std::vector<fit::Candidate>& candidates,
              const FittedHypothesis& fitted, const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis
