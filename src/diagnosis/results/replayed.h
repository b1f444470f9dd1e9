// Gaps of a component on logs as in `replay` and the node: driven by the displacement as recorded.
#pragma once

#include <vector>

#include "diagnosis/prepare/log_survey.h"
#include "diagnosis/results/law_fit.h"
#include "fit/fitter.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {

/// Errors of parts of logs, without the errors of the rig in each log.
struct Replayed {
  std::vector<gap::PartError> of_the_fit;  ///< on blocks that took no part in the fit
  std::vector<gap::PartError> held_out;    ///< on the held-out logs; empty if there are none

  /// Returns the errors of which gaps are computed.
  const std::vector<gap::PartError>& unseen() const { return held_out.empty() ? of_the_fit : held_out; }
};

/// Returns the elements of a model with a law.
Entries elementsOf(const fit::ModelParameters& model, const FittedLaw& fitted);

/// Returns the errors of a fitted law that is written as these elements, on the logs of the fit and on those held out.
/// For logs of the fit they are the cross-validated errors plus, log by log, the excess of `replay` over the fitted
/// forces, which is due to noise of the displacement and to future samples that a simulation does not have.
Replayed replayed(const fit::Fitter& fitter, const FittedLaw& fitted, const Entries& elements,
                  const std::vector<gap::PreparedRecord>& held_out);

/// Returns only the errors of which gaps are computed, Replayed::unseen().
std::vector<gap::PartError> unseenErrors(const fit::Fitter& fitter, const FittedLaw& fitted, const Entries& elements,
                                         const std::vector<gap::PreparedRecord>& held_out);

/// Logs recorded on one component, which relaxes between them, or each on a new one.
enum class Recorded { on_one_component, each_on_a_new_one };

/// Returns the gap of each list of elements on whole logs as `replay` computes it, at even time steps: the RMS over the
/// logs of their gaps. Each log is read once, block by block. Throws LogError if a log has no force or has become
/// shorter since its survey.
std::vector<double> recordedGaps(const std::vector<std::vector<element::ElementDescription>>& models,
                                 const std::vector<prepare::LogSurvey>& logs, Recorded recorded, int threads);

}  // namespace rubber_suspension::diagnosis::results
