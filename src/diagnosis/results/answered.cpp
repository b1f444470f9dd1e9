// Effects by name, and how much each closes.
#include "diagnosis/results/answered.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "diagnosis/results/augmented.h"
#include "diagnosis/results/predictive.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

double closedBy(const Diagnosis& diagnosis, double gap) {
  return std::min(1.0, gap::closedFraction(diagnosis.gap.re_estimated, gap, diagnosis.gap.noise_floor));
}

// Predicted of further logs; those that the gap is of are further logs, too.
std::array<double, 2> holding(double closed, const Closing& closing, const Evidence& evidence,
                              const DiagnosisOptions& options) {
  const std::array<double, 2> interval = closedOnFurtherLogs(evidence, closing, options.resamplings, options.seed);
  return {std::min(interval[0], closed), std::max(interval[1], closed)};
}

}  // namespace

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

void addClosed(const Workings& workings, const DiagnosisOptions& options, Diagnosis& diagnosis) {
  const double closed = closedBy(diagnosis, diagnosis.gap.augmented);
  diagnosis.closed = closed;
  diagnosis.closed_interval = workings.answer.effects.empty()
                                  ? std::array{closed, closed}
                                  : holding(closed, closingOf(workings.answer), workings.evidence, options);
}

CandidateResult candidateResult(const Workings& workings, const DiagnosisOptions& options, const Diagnosis& diagnosis,
                                std::size_t candidate, double gap) {
  const Search& search = workings.search;
  const std::vector<int>& named = workings.answer.effects;
  const int hypothesis = Evidence::kFirstSingle + static_cast<int>(candidate);
  CandidateResult result;
  result.effect = search.candidates[candidate].effect;
  result.documentation = search.candidates[candidate].documentation;
  result.on_rig = search.candidates[candidate].on_rig;
  result.probability = workings.answer.candidates[candidate];
  result.gap = gap;
  result.closed = closedBy(diagnosis, gap);
  result.interval = hypothesis == workings.answer.model
                        ? diagnosis.closed_interval
                        : holding(result.closed, {hypothesis}, workings.evidence, options);
  result.visible_share = search.visible_share[candidate];
  result.testable =
      search.testable[candidate] || std::count(named.begin(), named.end(), static_cast<int>(candidate)) > 0;
  result.add = entriesOf(search.singles[candidate]);
  result.parameters = headlineOf(result.add);
  return result;
}

void sortByProbability(std::vector<CandidateResult>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(), [](const CandidateResult& a, const CandidateResult& b) {
    return a.probability != b.probability ? a.probability > b.probability : a.closed > b.closed;
  });
}

}  // namespace rubber_suspension::diagnosis
