// How large the named effects and the model's parameters are, with what the logs leave open.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/results/law_fit.h"
#include "fit/hypothesis_fitter.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

struct Sizes {
  std::vector<SizedValue> model;    ///< numbers of the specification, or of the elements where there is none
  std::vector<SizedValue> effects;  ///< headline numbers of each member of the law, in their order
  std::vector<SizedValue> written;  ///< every number of its component, by its place there (io::numberPlace)
};

/// A law, what fitted it, and how probable it is beside the others, up to a factor.
struct SizedLaw {
  const fit::HypothesisFitter& fitter;
  const FittedLaw& fitted;
  double weight = 1.0;
};

/// Sizes of the first of several laws of the same effects. Intervals are percentiles over resampled blocks of
/// the logs: each resample moves the fit by one step of its own normal equations, within the bounds of the fit, and the
/// numbers of each member by what its form error may be mistaken for. Those of the model and of the effects are over
/// all laws that have the same sizes, by their weights. `effects`: names of the members.
Sizes sizesOf(const std::vector<SizedLaw>& laws, const std::vector<double>& form_error,
              const std::vector<std::string>& effects, const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis
