// Effects by name.
#include "diagnosis/results/answered.h"

#include <algorithm>
#include <iterator>

namespace rubber_suspension::diagnosis {

void addAnswer(const Answer& answer, const Evidence& evidence, Diagnosis& diagnosis) {
  const auto names = [&](const std::vector<int>& effects) {
    std::vector<std::string> result;
    std::transform(effects.begin(), effects.end(), std::back_inserter(result),
                   [&](int effect) { return evidence.effects[static_cast<std::size_t>(effect)]; });
    return result;
  };
  diagnosis.verdict = answer.verdict;
  diagnosis.probability = answer.probability;
  diagnosis.effects = names(answer.effects);
  diagnosis.posterior = answer.posterior;
  std::transform(answer.confounded.begin(), answer.confounded.end(), std::back_inserter(diagnosis.confounded), names);
  for (const Explained& other : answer.alternatives) {
    diagnosis.alternatives.push_back({other.verdict, names(other.effects), other.probability});
  }
}

}  // namespace rubber_suspension::diagnosis
