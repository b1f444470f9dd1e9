// Selects competing explanations and predicts how one more log would change their probabilities.
#include "diagnosis/experiment/explanation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <utility>

#include "diagnosis/judge/score.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::experiment {
namespace {

constexpr std::size_t kMost = 6;  // largest number of explanations; each has to be fitted to each motion of the menu

using Ranked = std::pair<double, int>;  // probability and hypothesis

// Returns the judged hypothesis, followed by the others sorted by probability.
std::vector<Ranked> rankedHypotheses(const Workings& workings) {
  const judge::SetPosterior posterior = judge::setPosterior(workings.table, judge::fittedNumbers());
  std::vector<Ranked> ranked = {{posterior.none, judge::Evidence::kAsConfigured},
                                {posterior.parameter_error, judge::Evidence::kReEstimated}};
  for (const judge::SetProbability& set : posterior.sets) {
    ranked.emplace_back(set.sum(), set.hypothesis);
  }
  const judge::Answer& answer = workings.answer;
  std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) { return a.first > b.first; });
  const auto judged =
      std::find_if(ranked.begin(), ranked.end(), [&](const Ranked& one) { return one.second == answer.model; });
  judged->first = answer.probability;  // may be the probability of an unlisted cause alone
  std::rotate(ranked.begin(), judged, judged + 1);
  return ranked;
}

}  // namespace

std::vector<Explanation> explanationsOf(const Workings& workings) {
  const judge::ScoreTable& table = workings.table;
  const Eigen::ArrayXXd squares = judge::expectedSquares(table, judge::fittedNumbers());
  const auto onAverage = [&](const Eigen::ArrayXXd& ofLogs, int hypothesis) {
    return ofLogs.row(hypothesis).matrix().dot(table.weight.matrix());
  };
  const Eigen::ArrayXXd losses = table.left.binaryExpr(
      squares, [](double left, double s2) { return judge::lossOf(left, s2, judge::fittedNumbers()); });
  std::vector<Explanation> explanations;
  double sum = 0.0;
  for (const auto& [probability, hypothesis] : rankedHypotheses(workings)) {
    const hypotheses::FittedHypothesis& fitted = workings.search.at(hypothesis);
    if (explanations.size() < kMost && std::isfinite(fitted.fit.held_out) && probability > 0.0) {
      explanations.push_back({&fitted, probability, onAverage(squares, hypothesis), onAverage(losses, hypothesis),
                              judge::usualSize(table, judge::fittedNumbers()),
                              judge::sharpnessOf(table, judge::fittedNumbers())});
      sum += probability;
    }
  }
  for (Explanation& explanation : explanations) {
    explanation.probability /= sum;
  }
  return explanations;
}

std::vector<double> probabilitiesOf(const std::vector<Explanation>& explanations) {
  return element::each(explanations, [](const Explanation& explanation) { return explanation.probability; });
}

double openNames(const std::vector<Explanation>& explanations, const std::vector<double>& weights) {
  std::map<int, double> with;  // weight of the explanations that contain each effect
  double sum = 0.0;
  for (std::size_t e = 0; e < explanations.size(); ++e) {
    sum += weights[e];
    for (const int member : explanations[e].fitted->hypothesis.members) {
      with[member] += weights[e];
    }
  }
  const auto bits = [](double p) { return p > 0.0 ? -p * std::log2(p) : 0.0; };
  return std::accumulate(with.begin(), with.end(), 0.0, [&](double open, const auto& effect) {
    const double p = std::min(1.0, effect.second / sum);
    return open + bits(p) + bits(1.0 - p);
  });
}

Outlook outlookOf(std::size_t right, const std::vector<Explanation>& explanations,
                  const std::vector<Refitted>& refitted, double noise, double logs) {
  constexpr int kDraws = 200;
  const judge::JudgeNumbers& numbers = judge::fittedNumbers();
  std::mt19937 generator(1);
  std::student_t_distribution<double> form(numbers.tails);
  Outlook outlook;
  std::vector<double> weights(explanations.size());
  for (int draw = 0; draw < kDraws; ++draw) {
    const double form_error = (explanations[right].expected + noise) * std::pow(form(generator), 2);
    for (std::size_t e = 0; e < explanations.size(); ++e) {
      const Explanation& one = explanations[e];
      const double loss = judge::lossOf(form_error + refitted[e].left, one.expected + noise, numbers);
      const double change = (loss - one.loss) / (logs + 1.0);
      weights[e] = one.probability * std::exp(refitted[e].prior - 0.5 * one.sharpness * change);
    }
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    outlook.alone += weights[right] >= judge::kListed * sum ? 1.0 / kDraws : 0.0;
    outlook.open += openNames(explanations, weights) / kDraws;
  }
  return outlook;
}

std::string nameOf(const hypotheses::Search& search, const hypotheses::FittedHypothesis& fitted) {
  std::string text;
  for (const int member : fitted.hypothesis.members) {
    text += (text.empty() ? "" : " + ") + search.candidates[static_cast<std::size_t>(member)].effect;
  }
  return text.empty() ? "the model as configured" : text;
}

}  // namespace rubber_suspension::diagnosis::experiment
