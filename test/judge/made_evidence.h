// Artificial evidence: the residuals of hypotheses in each log, drawn or given.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::test {

/// Squares are in units of the variance of the force. A single value applies to all logs.
constexpr double kFloor = 0.003;  // noise floor as a gap

inline diagnosis::judge::HypothesisEvidence fitted(std::vector<int> members, std::vector<double> log_errors,
                                                   std::vector<std::vector<double>> sizes) {
  diagnosis::judge::HypothesisEvidence hypothesis;
  hypothesis.terms = 5 * members.size();
  hypothesis.members = std::move(members);
  hypothesis.sizes = std::move(sizes);
  hypothesis.log_errors = std::move(log_errors);
  return hypothesis;
}

/// Returns evidence of a model with a gap of `left` in each log, and of effects that reduce no residual and add no
/// force. The fitted numbers do not know these effects. The first log has all blocks.
inline diagnosis::judge::Evidence unexplained(std::size_t logs, int effects, double left, std::size_t blocks = 50) {
  diagnosis::judge::Evidence evidence;
  evidence.logs.assign(logs, {kFloor, 0.1, 1.0, false, 0});
  evidence.logs.front().blocks = blocks;
  const std::vector<double> errors(logs, left * left);
  evidence.hypotheses = {fitted({}, std::vector<double>(logs, 1.5 * left * left), {}), fitted({}, errors, {})};
  for (int effect = 0; effect < effects; ++effect) {
    evidence.hypotheses.push_back(fitted({effect}, errors, {std::vector<double>(logs, 0.0)}));
    evidence.effects.push_back("effect_" + std::to_string(effect));
    evidence.one_form.push_back(false);
    evidence.constant.push_back(false);
    evidence.contains.emplace_back();
  }
  return evidence;
}

/// Sets the gap of a single effect to `left`. The square of the residual falls by the square of the effect's force.
inline void explain(diagnosis::judge::Evidence& evidence, int effect, double left) {
  diagnosis::judge::HypothesisEvidence& single =
      evidence.hypotheses[static_cast<std::size_t>(diagnosis::judge::Evidence::kFirstSingle + effect)];
  const double before = evidence.at(diagnosis::judge::Evidence::kReEstimated).log_errors.front();
  single = fitted({effect}, std::vector<double>(single.log_errors.size(), left * left),
                  {std::vector<double>(single.log_errors.size(), before - left * left)});
}

}  // namespace rubber_suspension::test
