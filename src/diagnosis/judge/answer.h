// The verdict, which follows from the posterior alone.
#pragma once

#include <vector>

#include "diagnosis/judge/set_posterior.h"
#include "rubber_suspension/diagnosis/posterior.h"
#include "rubber_suspension/diagnosis/verdict.h"

namespace rubber_suspension::diagnosis::judge {

/// Probability that lists of explanations cover. An explanation with at least this probability is listed alone.
constexpr double kListed = 0.9;

/// An explanation of the logs: a set of effects (`named`), wrong values, no gap, or an unlisted cause (`unknown`).
struct Explained {
  Verdict verdict = Verdict::none;
  std::vector<int> effects;            ///< sorted by the size of their forces, the largest first
  int model = Evidence::kReEstimated;  ///< index of the hypothesis that represents the explanation
  double probability = 0.0;
};

struct Answer {
  Verdict verdict = Verdict::none;
  std::vector<int> effects;            ///< named effects, sorted by the size of their forces, the largest first
  int model = Evidence::kReEstimated;  ///< index of the judged hypothesis
  double probability = 0.0;        ///< probability of the verdict; if effects are named, of the set of these effects
  double beside = 0.0;             ///< conditional probability of an unlisted cause, given the named set
  Posterior posterior;             ///< probabilities of the four answers
  std::vector<double> candidates;  ///< for each effect: probability that it is at work
  std::vector<std::vector<int>> confounded;  ///< likeliest sets, with 90 % of the probability of all sets
  std::vector<Explained> alternatives;       ///< likeliest other explanations, 90 % together with the answer
};

/// Returns the answer that follows from a posterior. If all sets of effects together are likelier than any other
/// answer, the likeliest set is named. The verdict is then `confounded` if this set has less than half of the
/// probability of all sets. Otherwise it is `partly` if this set is likelier with an unlisted cause than without. Sets
/// that contain an effect with a probability of less than 2 % are not listed, except for the named set. The verdict is
/// never `unknown` if a set halves the squared residual (toldByHalving()).
Answer answer(const SetPosterior& posterior, std::size_t effects);

Answer answer(const ScoreTable& table, const JudgeNumbers& numbers = fittedNumbers());

/// Returns the answer that follows from the evidence. Throws std::invalid_argument like scoreTable().
Answer answer(const Evidence& evidence, const JudgeNumbers& numbers = fittedNumbers());

}  // namespace rubber_suspension::diagnosis::judge
