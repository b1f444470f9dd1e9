// Weights of the answers, from what each leaves above the noise floor.
#include "diagnosis/judge/posterior.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnosis/judge/weighing.h"

namespace rubber_suspension::diagnosis {
namespace {

enum Answer { kNone, kParameters, kEffect, kNoneOfThese, kAnswers };
using Weights = std::array<double, kAnswers>;

constexpr double kRefuted = 0.5;  // of the verdict's weight, at most: a test can err, too

Answer answerOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::none:
      return kNone;
    case Verdict::parameter_error:
      return kParameters;
    case Verdict::unknown:
      return kNoneOfThese;
    default:
      return kEffect;
  }
}

class Answers {
 public:
  Answers(const Evidence& evidence, const Criteria& criteria, const Judgement& judgement)
      : evidence_(evidence), criteria_(criteria), weighing_(evidence, criteria), judgement_(judgement) {}

  Weights weights() const {
    const double configured = weighing_.left(evidence_.at(Evidence::kAsConfigured));
    const double values = std::min(configured, weighing_.left(evidence_.reEstimated()));
    const double effect = std::min(values, leastWithEffects());
    const double other = (1.0 - criteria_.unknown) * values;
    const double of_values = power(configured, values);
    return {1.0, of_values - 1.0, power(configured, effect) - of_values, power(configured, other) - of_values};
  }

 private:
  // Softened such that what counts as nothing left weighs twice as much as nothing: even odds with the simpler answer.
  double power(double before, double after) const {
    const double counts = judgement_.effects.empty() ? weighing_.tolerated() : weighing_.insignificant();
    const double blur = counts * counts / (std::pow(2.0, 1.0 / criteria_.sharpness) - 1.0);
    return std::pow((before * before + blur) / (after * after + blur), criteria_.sharpness);
  }

  // Of the effects that are named; else of those that may be.
  double leastWithEffects() const {
    if (!judgement_.effects.empty()) {
      return weighing_.left(evidence_.at(judgement_.model));
    }
    const std::optional<int> best = weighing_.bestSingle();
    return weighing_.left(evidence_.at(best.value_or(Evidence::kReEstimated)));
  }

  const Evidence& evidence_;
  const Criteria& criteria_;
  Weighing weighing_;
  const Judgement& judgement_;
};

}  // namespace

Posterior posterior(const Evidence& evidence, const Criteria& criteria, const Judgement& judgement) {
  Weights weights = Answers(evidence, criteria, judgement).weights();
  double& verdict = weights[answerOf(judgement.verdict)];
  // A verdict that nothing but a test speaks for.
  constexpr double kLeast = 1e-3;
  verdict = std::max(verdict, kLeast);
  double sum = 0.0;
  for (double& weight : weights) {
    if (&weight != &verdict && weight >= verdict) {
      weight = kRefuted * verdict;
    }
    sum += weight;
  }
  return {weights[kNone] / sum, weights[kParameters] / sum, weights[kEffect] / sum, weights[kNoneOfThese] / sum};
}

Posterior sharedWithValues(Posterior answers) {
  answers.effects = answers.parameter_error = 0.5 * answers.parameter_error;
  answers.none = std::min(answers.none, kRefuted * answers.effects);
  answers.none_of_these = std::min(answers.none_of_these, kRefuted * answers.effects);
  const double sum = answers.none + answers.parameter_error + answers.effects + answers.none_of_these;
  return {answers.none / sum, answers.parameter_error / sum, answers.effects / sum, answers.none_of_these / sum};
}

}  // namespace rubber_suspension::diagnosis
