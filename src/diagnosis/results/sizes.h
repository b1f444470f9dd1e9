// How large the named effects and the model's parameters are, with what the logs leave open.
#pragma once

#include <vector>

#include "diagnosis/results/law_fit.h"
#include "fit/hypothesis_fitter.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Sets the sizes of a fitted law in a diagnosis: those of the model, headline numbers of each member of the law in
/// their order, and every number of its component by its place there (io::numberPlace). Intervals are percentiles over
/// resampled blocks of the logs: each resample moves the fit by one step of its own normal equations, within the bounds
/// of the fit, and the numbers of each member by what its form error may be mistaken for.
void addSizes(const fit::HypothesisFitter& fitter, const FittedLaw& fitted, const std::vector<double>& form_error,
              const std::vector<fit::Candidate>& candidates, const DiagnosisOptions& options, Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis
