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

/// The sizes of the first of several laws, between which no gap decides. Intervals are percentiles over resampled
/// blocks of the logs: each resample moves the fit by one step of its own normal equations, within the bounds of the
/// fit, what is known of the model beforehand by its own deviations, and the numbers of each member by what its form
/// error may be mistaken for. Those of the model and of headline numbers are over all laws that have them, alike; a
/// number of one element is the total of a law of several.
Sizes sizesOf(const fit::HypothesisFitter& fitter, const std::vector<WeighedLaw>& laws,
              const std::vector<double>& form_error, const hypotheses::Search& search, const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis::results
