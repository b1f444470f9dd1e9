// Sizes of the named effects and of the model's parameters, with their uncertainty.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/results/law_fit.h"
#include "fit/hypothesis_fitter.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// Numbers of a law.
struct Sizes {
  std::vector<SizedValue> model;    ///< its own parameters
  std::vector<SizedValue> effects;  ///< headline numbers of each member in their order
  std::vector<SizedValue> written;  ///< every number of its component by its place there (io::numberPlace)
};

/// Returns the sizes of the first of several laws whose gaps do not differ enough to choose one. Intervals are
/// percentiles over resampled blocks of the logs. Each resample moves the fit by one step of its own normal equations
/// within the bounds of the fit, the prior values of the model by their standard deviations, and the numbers of each
/// member by its form error. Intervals of the model's values and of headline numbers are over all laws that have them;
/// a number of one element corresponds to the total over the elements of another law.
Sizes sizesOf(const fit::HypothesisFitter& fitter, const std::vector<WeighedLaw>& laws,
              const std::vector<double>& form_error, const hypotheses::Search& search, const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis::results
