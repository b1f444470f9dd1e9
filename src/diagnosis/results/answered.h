// Turns the answer of the judgement into names of effects and parts of the gap that each effect closes.
#pragma once

#include <functional>
#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/judge/answer.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the answer with the names of effects instead of their indices.
Answered answered(const judge::Answer& answer, const judge::Evidence& evidence);

/// Gaps of the models, of the judged law, and of the model with a single effect.
struct Left {
  Gap gap;
  double full_law = 0.0;      ///< gap of the judged law with all its terms
  std::vector<double> alone;  ///< gap with a single effect, for each candidate
  judge::ScoreTable table;    ///< scores that use the errors of the written component
};

/// Returns the gap, with a noise floor no larger than the gap of any model. Also returns the fraction of the gap that
/// the answer closes, with the interval of this fraction for further logs.
Gaps gapsOf(const Left& left, const Workings& workings, const DiagnosisOptions& options);

/// Returns the results of the models with a single effect, the most probable effect first.
std::vector<CandidateResult> candidateResults(const Left& left, const Gaps& gaps, const Workings& workings,
                                              const DiagnosisOptions& options);

/// Replaces the numbers of each written effect by those in the component file (CandidateResult::written).
void tellAsWritten(const WrittenLaw& law, const std::vector<std::string>& effects, const Gaps& gaps,
                   std::vector<CandidateResult>& candidates);

/// A function that returns the gap with some of the changes of an answer: in[0] selects the values, in[1 + e] effect e.
using GapWith = std::function<double(const std::vector<bool>& in)>;

/// Returns the shares of the gap as configured (Shapley values) that the values and each effect remove.
std::vector<GapShare> sharesOf(const std::vector<std::string>& effects, const Gap& gap, const GapWith& gap_with,
                               int threads);

/// Returns the configured component with some of the changes of the augmented component, selected as in GapWith.
io::ComponentDescription withSome(const io::ComponentDescription& configured, const WrittenLaw& law,
                                  const std::vector<std::string>& effects, const std::vector<bool>& in);

/// Returns the ratios of re-estimated to configured parameters, and deviations of the judged model from the data sheet.
OwnParameters ownParameters(const fit::ModelParameters& model, const Eigen::VectorXd& re_estimated,
                            const Eigen::VectorXd& judged);

}  // namespace rubber_suspension::diagnosis::results
