// Computes gaps of a component on logs as `replay` and the node do, from the displacement as recorded.
#pragma once

#include <vector>

#include "diagnosis/prepare/log_survey.h"
#include "diagnosis/results/law_fit.h"
#include "fit/fitter.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {

/// Errors of parts of logs, after the errors of the rig in each log have been removed.
struct Replayed {
  std::vector<gap::PartError> of_the_fit;  ///< on blocks that took no part in the fit
  std::vector<gap::PartError> held_out;    ///< on the held-out logs; empty if there are none

  /// Returns the errors from which gaps are computed: `held_out`, or `of_the_fit` if there are no held-out logs.
  const std::vector<gap::PartError>& unseen() const { return held_out.empty() ? of_the_fit : held_out; }
};

Entries elementsOf(const fit::ModelParameters& model, const FittedLaw& fitted);

/// Returns the errors of a fitted law that is written as these elements, on the logs of the fit and on the held-out
/// logs. On a log of the fit, the errors are the cross-validated errors plus the excess of the error of `replay` over
/// that of the fitted forces. The causes of this excess are noise of the displacement and future samples, which a
/// simulation does not have.
Replayed replayed(const fit::Fitter& fitter, const FittedLaw& fitted, const Entries& elements,
                  const std::vector<gap::PreparedRecord>& held_out);

/// Returns only the errors from which gaps are computed (Replayed::unseen()).
std::vector<gap::PartError> unseenErrors(const fit::Fitter& fitter, const FittedLaw& fitted, const Entries& elements,
                                         const std::vector<gap::PreparedRecord>& held_out);

/// States whether all logs were recorded on one component, which relaxes between them, or each log on a new one.
enum class Recorded { on_one_component, each_on_a_new_one };

/// Returns the gap of each list of elements on whole logs at even time steps, as `replay` computes it: the RMS of
/// the gaps of all logs. Reads each log once, block by block. Throws LogError if a log has no force or has become
/// shorter since its survey.
std::vector<double> recordedGaps(const std::vector<std::vector<element::ElementDescription>>& models,
                                 const std::vector<prepare::LogSurvey>& logs, Recorded recorded, int threads);

}  // namespace rubber_suspension::diagnosis::results
