// The verdict as a function of the posterior alone.
#pragma once

#include <vector>

#include "diagnosis/judge/set_posterior.h"
#include "rubber_suspension/diagnosis/posterior.h"
#include "rubber_suspension/diagnosis/verdict.h"

namespace rubber_suspension::diagnosis::judge {

/// Probability that lists have to cover; an explanation with at least this probability stands alone.
constexpr double kListed = 0.9;

/// An explanation of the logs: a set of effects (`named`), wrong values, no gap, or an unlisted cause (`unknown`).
struct Explained {
  Verdict verdict = Verdict::none;
  std::vector<int> effects;            ///< largest force first
  int model = Evidence::kReEstimated;  ///< the hypothesis that represents it
  double probability = 0.0;
};

/// The verdict and its probability.
struct Answer {
  Verdict verdict = Verdict::none;
  std::vector<int> effects;                  ///< named effects, largest force first
  int model = Evidence::kReEstimated;        ///< the judged hypothesis
  double probability = 0.0;                  ///< of the verdict; if effects are named, of their set
  double beside = 0.0;                       ///< share of the named set's probability that is beside a residual force
  Posterior posterior;                       ///< of the four answers
  std::vector<double> candidates;            ///< for each effect, that it is at work
  std::vector<std::vector<int>> confounded;  ///< sets with 90 % of the probability of all sets, the likeliest first
  std::vector<Explained> alternatives;       ///< likeliest others, until 90 % are covered with the answer
};

/// Returns the answer to a posterior. If all sets together are likelier than any other answer, the likeliest set is
/// named. The verdict is then `confounded` if this set has less than half of the probability of all sets, or `partly`
/// if it is likelier beside a residual force than alone. Sets with an effect of less than 2 % are not listed, except
/// for the named one. The verdict is never `unknown` if a set halves the residual (toldByHalving()).
Answer answer(const SetPosterior& posterior, std::size_t effects);

/// Returns the answer to a table of scores.
Answer answer(const ScoreTable& table, const JudgeNumbers& numbers = fittedNumbers());

/// Returns the answer to evidence. Throws std::invalid_argument like scoreTable().
Answer answer(const Evidence& evidence, const JudgeNumbers& numbers = fittedNumbers());

}  // namespace rubber_suspension::diagnosis::judge
