// From probabilities to a verdict: a function of the posterior alone, which compares nothing else.
#pragma once

#include <vector>

#include "diagnosis/judge/judge.h"
#include "diagnosis/judge/set_posterior.h"

namespace rubber_suspension::diagnosis {

/// What is said, and how sure it is.
struct Answer {
  Verdict verdict = Verdict::none;
  std::vector<int> effects;                  ///< named, what adds most to the force first
  int model = Evidence::kReEstimated;        ///< the hypothesis that is judged
  double probability = 0.0;                  ///< of the verdict; of the set that is named
  Posterior posterior;                       ///< of the four answers
  std::vector<double> candidates;            ///< of each effect, to be in the set that is at work
  std::vector<std::vector<int>> confounded;  ///< the sets that together make 90 % of all, the likeliest first
};

/// Something is named where all sets together are likelier than any other answer: the likeliest set. It is `confounded`
/// where that has less than half of the probability of all sets, `partly` where it is likelier beside a rest.
Answer answer(const SetPosterior& posterior, std::size_t effects);

/// Evidence to answer.
Answer answer(const NamedEvidence& named, const JudgeNumbers& numbers = fittedNumbers());

}  // namespace rubber_suspension::diagnosis
