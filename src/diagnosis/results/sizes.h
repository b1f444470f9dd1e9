// Computes the sizes of the named effects and of the parameters of the model, with their uncertainty.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/results/law_fit.h"
#include "fit/hypothesis_fitter.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

struct Sizes {
  std::vector<SizedValue> model;    ///< parameters of the model
  std::vector<SizedValue> effects;  ///< headline numbers of each effect, in the order of the hypothesis
  std::vector<SizedValue>
      written;  ///< every number of the component, named by its position in the file (io::numberPlace)
};

/// Returns the sizes according to the first of several laws, whose gaps differ too little to choose one law. Intervals
/// are percentiles over resampled blocks of the logs. Each resample moves the fit by one step of its own normal
/// equations within the bounds. It also varies the prior values of the model by their standard deviations, and the
/// numbers of each effect by its form error. Intervals of values of the model and of headline numbers include all laws
/// that have them. There, numbers of a single element are pooled with totals over several elements of another law.
Sizes sizesOf(const fit::HypothesisFitter& fitter, const std::vector<WeighedLaw>& laws,
              const std::vector<double>& form_error, const hypotheses::Search& search, const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis::results
