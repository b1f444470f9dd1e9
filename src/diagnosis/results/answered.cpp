// Effects by name, and how much each closes.
#include "diagnosis/results/answered.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <utility>

#include "diagnosis/hypotheses/fitted_component.h"
#include "diagnosis/results/predictive.h"
#include "diagnosis/words/headline.h"
#include "fit/parallel.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {
namespace {

double closedBy(const Diagnosis& diagnosis, double gap) {
  return std::min(1.0, gap::closedFraction(diagnosis.gap.re_estimated, gap, diagnosis.gap.noise_floor));
}

// Predicted of further logs; those that the gap is of are further logs, too.
std::array<double, 2> holding(double closed, const Closing& closing, const judge::Evidence& evidence,
                              const DiagnosisOptions& options) {
  const std::array<double, 2> interval = closedOnFurtherLogs(evidence, closing, options.resamplings, options.seed);
  return {std::min(interval[0], closed), std::max(interval[1], closed)};
}

CandidateResult candidateResult(const Workings& workings, const DiagnosisOptions& options, const Diagnosis& diagnosis,
                                std::size_t candidate, double gap) {
  const hypotheses::Search& search = workings.search;
  const std::vector<int>& named = workings.answer.effects;
  const int hypothesis = judge::Evidence::kFirstSingle + static_cast<int>(candidate);
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
  result.add = hypotheses::entriesOf(search.singles[candidate]);
  result.parameters = words::headlineOf(result.add);
  return result;
}

}  // namespace

void addAnswer(const judge::Answer& answer, const judge::Evidence& evidence, Diagnosis& diagnosis) {
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
  for (const judge::Explained& other : answer.alternatives) {
    diagnosis.alternatives.push_back({other.verdict, names(other.effects), other.probability});
  }
}

void addGap(const Gap& gap, const std::vector<std::vector<gap::PartError>>& alone, const judge::Evidence& evidence,
            const Workings& workings, const DiagnosisOptions& options, Diagnosis& diagnosis) {
  std::vector<double> gaps;
  std::transform(alone.begin(), alone.end(), std::back_inserter(gaps), gap::gapOfParts);
  diagnosis.gap = gap;
  double& floor = diagnosis.gap.noise_floor;
  floor = std::min({floor, gap.as_configured, gap.re_estimated, gap.augmented, diagnosis.gap_of_full_law});
  floor = std::accumulate(gaps.begin(), gaps.end(), floor, [](double a, double b) { return std::min(a, b); });
  const double closed = closedBy(diagnosis, gap.augmented);
  diagnosis.closed = closed;
  diagnosis.closed_interval = workings.answer.effects.empty()
                                  ? std::array{closed, closed}
                                  : holding(closed, closingOf(workings.answer), evidence, options);
  std::vector<CandidateResult>& candidates = diagnosis.candidates;
  candidates.resize(gaps.size());
  fit::parallelFor(gaps.size(), options.threads,
                   [&](std::size_t c) { candidates[c] = candidateResult(workings, options, diagnosis, c, gaps[c]); });
  std::stable_sort(candidates.begin(), candidates.end(), [](const CandidateResult& a, const CandidateResult& b) {
    return a.probability != b.probability ? a.probability > b.probability : a.closed > b.closed;
  });
}

std::array<io::ComponentDescription, 2> valuesAndEffects(const Diagnosis& diagnosis) {
  std::array parts = {diagnosis.augmented, diagnosis.configured};
  std::swap(parts[0].add, parts[1].add);
  return parts;
}

}  // namespace rubber_suspension::diagnosis::results
