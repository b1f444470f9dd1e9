// An answer as a diagnosis tells it, be it of logs or of a table: with the names of effects, and with what they close.
#pragma once

#include <functional>
#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/judge/answer.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// The answer with the names of effects.
Answered answered(const judge::Answer& answer, const judge::Evidence& evidence);

/// Gaps of the models, of the judged law, and with each effect alone.
struct Left {
  Gap gap;
  double full_law = 0.0;      ///< gap
  std::vector<double> alone;  ///< gaps, by candidate
  judge::ScoreTable table;    ///< of the evidence with the errors of what is written
};

/// The gap, of which noise is no more than what any of the models leaves, and the fraction of it that the answer
/// closes, with its interval on further logs.
Gaps gapsOf(const Left& left, const Workings& workings, const DiagnosisOptions& options);

/// Each effect alone, the likeliest first.
std::vector<CandidateResult> candidateResults(const Left& left, const Gaps& gaps, const Workings& workings,
                                              const DiagnosisOptions& options);

/// Tells of each effect that is written the numbers of the component file (CandidateResult::written).
void tellAsWritten(const WrittenLaw& law, const std::vector<std::string>& effects, const Gaps& gaps,
                   std::vector<CandidateResult>& candidates);

/// The gap with some of what an answer changes: first whether its values are in, then each of its effects.
using GapWith = std::function<double(const std::vector<bool>& in)>;

/// Shares of the gap as configured that values and each effect remove.
std::vector<GapShare> sharesOf(const std::vector<std::string>& effects, const Gap& gap, const GapWith& gap_with,
                               int threads);

/// A component with some of what the augmented one changes, which has these effects.
io::ComponentDescription withSome(const io::ComponentDescription& configured, const WrittenLaw& law,
                                  const std::vector<std::string>& effects, const std::vector<bool>& in);

/// Deviations of a fitted and of a judged model from the data sheet.
OwnParameters ownParameters(const fit::ModelParameters& model, const Eigen::VectorXd& re_estimated,
                            const Eigen::VectorXd& judged);

}  // namespace rubber_suspension::diagnosis::results
