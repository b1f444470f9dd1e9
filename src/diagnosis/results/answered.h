// The answer of a diagnosis of logs or of a table, with the names of effects and the part of the gap that each closes.
#pragma once

#include <functional>
#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/judge/answer.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the answer with the names of effects instead of their indices.
Answered answered(const judge::Answer& answer, const judge::Evidence& evidence);

/// Gaps of the models, of the judged law, and with each effect alone.
struct Left {
  Gap gap;
  double full_law = 0.0;      ///< gap
  std::vector<double> alone;  ///< gaps, by candidate
  judge::ScoreTable table;    ///< scores with the errors of the written component
};

/// Returns the gap, with a noise floor no larger than the gap of any model, and the fraction of it that the answer
/// closes, with its interval for further logs.
Gaps gapsOf(const Left& left, const Workings& workings, const DiagnosisOptions& options);

/// Returns the results of each effect alone, the most probable effect first.
std::vector<CandidateResult> candidateResults(const Left& left, const Gaps& gaps, const Workings& workings,
                                              const DiagnosisOptions& options);

/// Replaces the numbers of each written effect by those of the component file (CandidateResult::written).
void tellAsWritten(const WrittenLaw& law, const std::vector<std::string>& effects, const Gaps& gaps,
                   std::vector<CandidateResult>& candidates);

/// Gap with a selection of the changes of an answer: in[0] selects its values, the others its effects in order.
using GapWith = std::function<double(const std::vector<bool>& in)>;

/// Returns the shares (Shapley values) of the gap as configured that values and each effect remove.
std::vector<GapShare> sharesOf(const std::vector<std::string>& effects, const Gap& gap, const GapWith& gap_with,
                               int threads);

/// Returns the configured component with a selection (GapWith) of the changes of the augmented one.
io::ComponentDescription withSome(const io::ComponentDescription& configured, const WrittenLaw& law,
                                  const std::vector<std::string>& effects, const std::vector<bool>& in);

/// Returns the re-estimated ratios of the model, and the deviations of the judged model from the data sheet.
OwnParameters ownParameters(const fit::ModelParameters& model, const Eigen::VectorXd& re_estimated,
                            const Eigen::VectorXd& judged);

}  // namespace rubber_suspension::diagnosis::results
