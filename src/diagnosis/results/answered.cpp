// Names the effects of an answer and computes the part of the gap that each of them closes.
#include "diagnosis/results/answered.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <boost/math/special_functions/factorials.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "diagnosis/effect.h"
#include "diagnosis/hypotheses/fitted_component.h"
#include "diagnosis/results/predictive.h"
#include "element/each.h"
#include "fit/parallel.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {
namespace {

double closedBy(double left, const Gap& gap) {
  return std::min(1.0, gap::closedFraction(gap.re_estimated, left, gap.noise_floor));
}

// Returns the interval of the closed fraction that is predicted for further logs. The interval is extended to the
// fraction on the logs of the gap, because the fit did not use these logs either.
std::array<double, 2> holding(double closed, const Closing& closing, const judge::ScoreTable& table,
                              const DiagnosisOptions& options) {
  const std::array<double, 2> interval = closedOnFurtherLogs(table, closing, options.resamplings, options.seed);
  return {std::min(interval[0], closed), std::max(interval[1], closed)};
}

CandidateResult candidateResult(std::size_t candidate, double left, const Gaps& gaps, const Workings& workings,
                                const DiagnosisOptions& options) {
  const hypotheses::Search& search = workings.search;
  const hypotheses::Visibility& visibility = search.visibility[candidate];
  const std::vector<int>& named = workings.answer.effects;
  const int hypothesis = judge::Evidence::kFirstSingle + static_cast<int>(candidate);
  CandidateResult result;
  result.effect = search.candidates[candidate].effect;
  result.documentation = search.candidates[candidate].documentation;
  result.on_rig = search.candidates[candidate].on_rig;
  result.probability = workings.answer.candidates[candidate];
  result.gap = left;
  result.closed = closedBy(left, gaps.unseen);
  result.interval = hypothesis == workings.answer.model ? gaps.closed_interval
                                                        : holding(result.closed, {hypothesis}, workings.table, options);
  result.visible_share = visibility.share;
  result.testable = visibility.testable || std::count(named.begin(), named.end(), static_cast<int>(candidate)) > 0;
  result.add = hypotheses::entriesOf(search.singles[candidate]);
  result.parameters = headlineOf(result.add);
  return result;
}

// Returns the weight of the Shapley value: the share of all orders of `parts` parts in which one given part follows
// directly after `before` given other parts.
double ordersWith(std::size_t before, std::size_t parts) {
  return boost::math::factorial<double>(static_cast<unsigned>(before)) *
         boost::math::factorial<double>(static_cast<unsigned>(parts - before - 1)) /
         boost::math::factorial<double>(static_cast<unsigned>(parts));
}

// Returns the excluded effects with the probabilities that they would have if no effect were excluded.
std::vector<ExcludedEffect> excludedOf(const judge::Evidence& evidence) {
  if (std::count(evidence.excluded.begin(), evidence.excluded.end(), true) == 0) {
    return {};
  }
  judge::Evidence nothing_excluded = evidence;
  nothing_excluded.excluded.clear();
  const std::vector<double> otherwise = judge::answer(nothing_excluded).candidates;
  std::vector<ExcludedEffect> excluded;
  for (std::size_t e = 0; e < evidence.excluded.size(); ++e) {
    if (evidence.excluded[e]) {
      excluded.push_back({evidence.effects[e], otherwise[e]});
    }
  }
  return excluded;
}

}  // namespace

Answered answered(const judge::Answer& answer, const judge::Evidence& evidence) {
  const auto names = [&](const std::vector<int>& effects) {
    return element::each(effects, [&](int effect) { return evidence.effects[static_cast<std::size_t>(effect)]; });
  };
  const auto alternative = [&](const judge::Explained& other) {
    return Alternative{other.verdict, names(other.effects), other.probability};
  };
  return {answer.verdict,
          answer.probability,
          names(answer.effects),
          element::each(answer.confounded, names),
          element::each(answer.alternatives, alternative),
          excludedOf(evidence),
          answer.posterior};
}

Gaps gapsOf(const Left& left, const Workings& workings, const DiagnosisOptions& options) {
  Gaps gaps;
  gaps.noise_source = workings.search.noise.source;
  gaps.unseen = left.gap;
  double& floor = gaps.unseen.noise_floor;
  floor = std::min({floor, left.gap.as_configured, left.gap.re_estimated, left.gap.augmented, left.full_law});
  floor =
      std::accumulate(left.alone.begin(), left.alone.end(), floor, [](double a, double b) { return std::min(a, b); });
  gaps.closed = closedBy(left.gap.augmented, gaps.unseen);
  gaps.closed_interval = workings.answer.effects.empty()
                             ? std::array{gaps.closed, gaps.closed}
                             : holding(gaps.closed, closingOf(workings.answer), left.table, options);
  return gaps;
}

std::vector<CandidateResult> candidateResults(const Left& left, const Gaps& gaps, const Workings& workings,
                                              const DiagnosisOptions& options) {
  std::vector<CandidateResult> candidates(left.alone.size());
  fit::parallelFor(candidates.size(), options.threads,
                   [&](std::size_t c) { candidates[c] = candidateResult(c, left.alone[c], gaps, workings, options); });
  std::stable_sort(candidates.begin(), candidates.end(), [](const CandidateResult& a, const CandidateResult& b) {
    return a.probability != b.probability ? a.probability > b.probability : a.closed > b.closed;
  });
  return candidates;
}

void tellAsWritten(const WrittenLaw& law, const std::vector<std::string>& effects, const Gaps& gaps,
                   std::vector<CandidateResult>& candidates) {
  const std::size_t own = law.augmented.add.size() - law.added_for.size();
  for (CandidateResult& candidate : candidates) {
    candidate.written = std::count(effects.begin(), effects.end(), candidate.effect) > 0 &&
                        std::count(law.added_for.begin(), law.added_for.end(), candidate.effect) > 0;
    if (!candidate.written) {
      continue;
    }
    candidate.gap = gaps.unseen.augmented;
    candidate.closed = gaps.closed;
    candidate.interval = gaps.closed_interval;
    candidate.add.clear();
    for (std::size_t i = 0; i < law.added_for.size(); ++i) {
      if (law.added_for[i] == candidate.effect) {
        candidate.add.push_back(law.augmented.add[own + i]);
      }
    }
    candidate.parameters = headlineOf(candidate.add);
  }
}

std::vector<GapShare> sharesOf(const std::vector<std::string>& effects, const Gap& gap, const GapWith& gap_with,
                               int threads) {
  const std::size_t parts = 1 + effects.size();
  const std::size_t all = (std::size_t{1} << parts) - 1;
  std::vector<double> gaps(all + 1);  // indexed by a bit mask of the included parts
  fit::parallelFor(gaps.size(), threads, [&](std::size_t in) {
    std::vector<bool> which;
    for (std::size_t part = 0; part < parts; ++part) {
      which.push_back((in >> part & 1U) != 0);
    }
    gaps[in] = in == 0 ? gap.as_configured : in == all ? gap.augmented : gap_with(which);
  });
  std::vector<GapShare> shares;
  for (std::size_t part = 0; part < parts; ++part) {
    double removed = 0.0;
    for (std::size_t in = 0; in <= all; ++in) {
      if ((in >> part & 1U) == 0) {
        removed += ordersWith(std::bitset<32>(in).count(), parts) * (gaps[in] - gaps[in | std::size_t{1} << part]);
      }
    }
    shares.push_back({part == 0 ? "values" : effects[part - 1],
                      removed / std::max(gap.as_configured, std::numeric_limits<double>::min())});
  }
  return shares;
}

io::ComponentDescription withSome(const io::ComponentDescription& configured, const WrittenLaw& law,
                                  const std::vector<std::string>& effects, const std::vector<bool>& in) {
  io::ComponentDescription result = in[0] ? law.augmented : configured;
  const auto& all = law.augmented.add;
  const auto own = static_cast<std::ptrdiff_t>(all.size() - law.added_for.size());
  result.add.assign((in[0] ? all : configured.add).begin(), (in[0] ? all : configured.add).begin() + own);
  for (std::size_t i = 0; i < law.added_for.size(); ++i) {
    const auto effect = std::find(effects.begin(), effects.end(), law.added_for[i]);
    if (effect != effects.end() && in[1 + static_cast<std::size_t>(effect - effects.begin())]) {
      result.add.push_back(all[static_cast<std::size_t>(own) + i]);
    }
  }
  return result;
}

OwnParameters ownParameters(const fit::ModelParameters& model, const Eigen::VectorXd& re_estimated,
                            const Eigen::VectorXd& judged) {
  constexpr double kAtBound = 1e-6;
  OwnParameters own;
  own.ratios = model.ratios(re_estimated);
  own.guess = model.isGuess();
  const Eigen::VectorXd departures = model.departures(judged);
  for (std::size_t i = 0; i < model.known().size(); ++i) {
    if (model.known()[i].of_sheet) {
      own.sheet_deviations.push_back({model.known()[i].name, departures[static_cast<Eigen::Index>(i)]});
    }
  }
  std::stable_sort(own.sheet_deviations.begin(), own.sheet_deviations.end(),
                   [](const auto& a, const auto& b) { return std::abs(a.tolerances) > std::abs(b.tolerances); });
  for (Eigen::Index i = 0; i < model.size(); ++i) {
    if (model.bounds()[i] - std::abs(judged[i]) < kAtBound) {
      own.at_bounds.push_back(model.names()[static_cast<std::size_t>(i)]);
    }
  }
  return own;
}

}  // namespace rubber_suspension::diagnosis::results
