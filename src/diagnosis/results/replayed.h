// Gaps of a component on logs as in `replay` and the node: driven by the displacement as recorded.
#pragma once

#include <vector>

#include "diagnosis/prepare/log_survey.h"
#include "diagnosis/results/law_fit.h"
#include "fit/fitter.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {

/// Errors of parts of logs, what the rig did to each log taken out.
struct Replayed {
  std::vector<gap::PartError> of_the_fit;  ///< on blocks that took no part in the fit
  std::vector<gap::PartError> held_out;    ///< of the logs held out; empty without any

  /// Errors that gaps refer to.
  const std::vector<gap::PartError>& unseen() const { return held_out.empty() ? of_the_fit : held_out; }
};

/// The elements of a model with a law.
Entries elementsOf(const fit::ModelParameters& model, const FittedLaw& fitted);

/// Errors of a fitted law that is written as these elements, on the logs of the fit and on those held out. For logs of
/// the fit they are the cross-validated errors plus, log by log, the excess of `replay` over the fitted forces, which
/// is due to noise of the displacement and to future samples that a simulation does not have.
Replayed replayed(const fit::Fitter& fitter, const FittedLaw& fitted, const Entries& elements,
                  const std::vector<gap::PreparedRecord>& held_out);

/// Errors of elements that gaps refer to.
std::vector<gap::PartError> unseenErrors(const fit::Fitter& fitter, const FittedLaw& fitted, const Entries& elements,
                                         const std::vector<gap::PreparedRecord>& held_out);

/// Logs of one component, which relaxes between them, or each of a new one.
enum class Recorded { on_one_component, each_on_a_new_one };

/// Gap of each of several lists of elements to whole logs as `replay` gives it, at even time steps: the root of the
/// mean over the logs of their squared gaps. Each log is read once, block by block. Throws LogError where a log has no
/// force or is no longer what it was in the survey.
std::vector<double> recordedGaps(const std::vector<std::vector<element::ElementDescription>>& models,
                                 const std::vector<prepare::LogSurvey>& logs, Recorded recorded, int threads);

}  // namespace rubber_suspension::diagnosis::results
