// Effects by name, and how much each closes.
#include "diagnosis/results/answered.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <boost/math/special_functions/factorials.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "diagnosis/hypotheses/fitted_component.h"
#include "diagnosis/results/headline.h"
#include "diagnosis/results/predictive.h"
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
  result.parameters = headlineOf(result.add);
  return result;
}

// Of all orders of so many parts, the share in which a certain one comes after these, and no other.
double ordersWith(std::size_t before, std::size_t parts) {
  return boost::math::factorial<double>(static_cast<unsigned>(before)) *
         boost::math::factorial<double>(static_cast<unsigned>(parts - before - 1)) /
         boost::math::factorial<double>(static_cast<unsigned>(parts));
}

// The same judgement with nothing excluded.
void addExcluded(const judge::Evidence& evidence, Diagnosis& diagnosis) {
  judge::Evidence nothing_excluded = evidence;
  nothing_excluded.excluded.clear();
  const std::vector<double> otherwise = judge::answer(nothing_excluded).candidates;
  for (std::size_t e = 0; e < evidence.excluded.size(); ++e) {
    if (evidence.excluded[e]) {
      diagnosis.excluded.push_back({evidence.effects[e], otherwise[e]});
    }
  }
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
  addExcluded(evidence, diagnosis);
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

void addShares(const GapWith& gap_with, int threads, Diagnosis& diagnosis) {
  const std::size_t parts = 1 + diagnosis.effects.size();
  const std::size_t all = (std::size_t{1} << parts) - 1;
  std::vector<double> gaps(all + 1);  // by the parts that are in, a bit each
  fit::parallelFor(gaps.size(), threads, [&](std::size_t in) {
    std::vector<bool> which;
    for (std::size_t part = 0; part < parts; ++part) {
      which.push_back((in >> part & 1U) != 0);
    }
    gaps[in] = in == 0 ? diagnosis.gap.as_configured : in == all ? diagnosis.gap.augmented : gap_with(which);
  });
  diagnosis.gap_of_values = gaps[1];
  diagnosis.shares.clear();
  for (std::size_t part = 0; part < parts; ++part) {
    double removed = 0.0;
    for (std::size_t in = 0; in <= all; ++in) {
      if ((in >> part & 1U) == 0) {
        removed += ordersWith(std::bitset<32>(in).count(), parts) * (gaps[in] - gaps[in | std::size_t{1} << part]);
      }
    }
    diagnosis.shares.push_back({part == 0 ? "values" : diagnosis.effects[part - 1],
                                removed / std::max(diagnosis.gap.as_configured, std::numeric_limits<double>::min())});
  }
}

io::ComponentDescription withSome(const Diagnosis& diagnosis, const std::vector<bool>& in) {
  io::ComponentDescription result = in[0] ? diagnosis.augmented : diagnosis.configured;
  const auto& all = diagnosis.augmented.add;
  const auto configured = static_cast<std::ptrdiff_t>(all.size() - diagnosis.added_for.size());
  result.add.assign((in[0] ? all : diagnosis.configured.add).begin(),
                    (in[0] ? all : diagnosis.configured.add).begin() + configured);
  for (std::size_t i = 0; i < diagnosis.added_for.size(); ++i) {
    const auto effect = std::find(diagnosis.effects.begin(), diagnosis.effects.end(), diagnosis.added_for[i]);
    if (effect != diagnosis.effects.end() && in[1 + static_cast<std::size_t>(effect - diagnosis.effects.begin())]) {
      result.add.push_back(all[static_cast<std::size_t>(configured) + i]);
    }
  }
  return result;
}

void addDepartures(const fit::ModelParameters& model, const Eigen::VectorXd& judged, Diagnosis& diagnosis) {
  constexpr double kAtBound = 1e-6;
  const Eigen::VectorXd departures = model.departures(judged);
  for (std::size_t i = 0; i < model.known().size(); ++i) {
    if (model.known()[i].of_sheet) {
      diagnosis.sheet_deviations.push_back({model.known()[i].name, departures[static_cast<Eigen::Index>(i)]});
    }
  }
  std::stable_sort(diagnosis.sheet_deviations.begin(), diagnosis.sheet_deviations.end(),
                   [](const auto& a, const auto& b) { return std::abs(a.tolerances) > std::abs(b.tolerances); });
  for (Eigen::Index i = 0; i < model.size(); ++i) {
    if (model.bounds()[i] - std::abs(judged[i]) < kAtBound) {
      diagnosis.at_bounds.push_back(model.names()[static_cast<std::size_t>(i)]);
    }
  }
}

}  // namespace rubber_suspension::diagnosis::results
