// From probabilities to a verdict: a function of the posterior alone, which compares nothing else.
#pragma once

#include <vector>

#include "diagnosis/judge/set_posterior.h"
#include "rubber_suspension/diagnosis/posterior.h"
#include "rubber_suspension/diagnosis/verdict.h"

namespace rubber_suspension::diagnosis::judge {

/// Probability that lists have to cover; an explanation that has as much stands alone.
constexpr double kListed = 0.9;

/// One explanation of the logs: a set of effects (`named`), wrong values, no gap, or something that is not in the list.
struct Explained {
  Verdict verdict = Verdict::none;
  std::vector<int> effects;            ///< what adds most to the force first
  int model = Evidence::kReEstimated;  ///< the hypothesis that stands for it
  double probability = 0.0;
};

/// The verdict, and how sure it is.
struct Answer {
  Verdict verdict = Verdict::none;
  std::vector<int> effects;                  ///< named, what adds most to the force first
  int model = Evidence::kReEstimated;        ///< the hypothesis that is judged
  double probability = 0.0;                  ///< of the verdict; of the set that is named
  double beside = 0.0;                       ///< of that set, the share that it has beside a rest
  Posterior posterior;                       ///< of the four answers
  std::vector<double> candidates;            ///< of each effect, to be in the set that is at work
  std::vector<std::vector<int>> confounded;  ///< the sets that together make 90 % of all, the likeliest first
  std::vector<Explained> alternatives;       ///< the likeliest others, which with what is said make 90 % of all
};

/// Something is named where all sets together are likelier than any other answer: the likeliest set. It is `confounded`
/// where that has less than half of the probability of all sets, `partly` where it is likelier beside a rest. No set is
/// listed that holds an effect of less than 2 %, but for the one that is named. Nothing is `unknown` where a set halves
/// what is left (toldByHalving()).
Answer answer(const SetPosterior& posterior, std::size_t effects);

/// The answer to the table of scores of all evidence.
Answer answer(const ScoreTable& table, const JudgeNumbers& numbers = fittedNumbers());

/// Evidence to answer. Throws std::invalid_argument as scoreTable() does.
Answer answer(const Evidence& evidence, const JudgeNumbers& numbers = fittedNumbers());

}  // namespace rubber_suspension::diagnosis::judge
