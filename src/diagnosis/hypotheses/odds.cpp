// Computes log weights of hypotheses from their error on all logs together.
#include "diagnosis/hypotheses/odds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/judge/numbers.h"
#include "diagnosis/judge/score.h"

namespace rubber_suspension::diagnosis::hypotheses {
namespace {

double square(double value) { return value * value; }

}  // namespace

double Odds::ofError(double error) const {
  if (!std::isfinite(error)) {
    return -std::numeric_limits<double>::infinity();
  }
  const judge::JudgeNumbers& numbers = judge::fittedNumbers();
  const double removed = std::max(0.0, square(without_) - square(error));
  const double expected =
      square(numbers.floor_known * floor_) + square(numbers.accepted) + square(numbers.form_error) * removed;
  const double left = std::max(0.0, square(error) - square(floor_));
  return -0.5 * numbers.sharpness * judge::lossOf(left, expected, numbers);
}

double Odds::of(const fit::Hypothesis& hypothesis, const Eigen::VectorXd& scales, double error) const {
  const judge::JudgeNumbers& numbers = judge::fittedNumbers();
  double prior = 0.0;
  std::size_t mechanisms = 0;
  for (const int member : hypothesis.members) {
    const fit::Candidate& candidate = candidates_[static_cast<std::size_t>(member)];
    prior += numbers.rateOf(candidate.effect);
    mechanisms += judge::mechanismsOf(candidate.contains.size());
  }
  prior += judge::priorOfCount(mechanisms, numbers);
  const std::size_t beyond = fit::numbersBeyond(candidates_, hypothesis, scales);
  const double factors = hypothesis.free_in_log.by_factor ? numbers.per_gain * logs_ : 0.0;
  return ofError(error) + prior - factors - judge::costOfNumbers(static_cast<double>(beyond), blocks_, numbers);
}

double Odds::mostOf(std::size_t effects) const {
  const judge::JudgeNumbers& numbers = judge::fittedNumbers();
  return ofError(floor_) + judge::priorOfCount(effects, numbers);
}

measurement::ErrorScale errorScale() {
  const judge::JudgeNumbers& numbers = judge::fittedNumbers();
  return {numbers.accepted, numbers.floor_known, numbers.sharpness};
}

}  // namespace rubber_suspension::diagnosis::hypotheses
