// Evidence that nobody measured: what hypotheses leave of logs, drawn or set.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/judge/evidence_json.h"

namespace rubber_suspension::test {

/// Squares in units of the force's variance, the same in each log where one is given.
constexpr double kFloor = 0.003;  // a gap

inline diagnosis::HypothesisEvidence fitted(std::vector<int> members, std::vector<double> log_errors,
                                            std::vector<std::vector<double>> sizes) {
  diagnosis::HypothesisEvidence hypothesis;
  hypothesis.terms = 5 * members.size();
  hypothesis.members = std::move(members);
  hypothesis.sizes = std::move(sizes);
  double sum = 0.0;
  for (const double error : log_errors) {
    sum += error;
  }
  hypothesis.held_out = std::sqrt(sum / static_cast<double>(log_errors.size()));
  hypothesis.log_errors = std::move(log_errors);
  return hypothesis;
}

/// A model that leaves `left` of each log (a gap), and effects that remove nothing of it and add no force. Effects have
/// names that no case told anything of.
inline diagnosis::NamedEvidence unexplained(std::size_t logs, int effects, double left, std::size_t blocks = 50) {
  diagnosis::NamedEvidence named;
  const std::vector<double> errors(logs, left * left);
  named.evidence.logs.assign(logs, {kFloor, 0.1, 1.0, false});
  named.evidence.noise_floor = kFloor;
  named.evidence.hypotheses = {fitted({}, std::vector<double>(logs, 1.5 * left * left), {}), fitted({}, errors, {})};
  named.evidence.hypotheses[1].block_errors.assign(blocks, left * left);
  for (int effect = 0; effect < effects; ++effect) {
    named.evidence.hypotheses.push_back(fitted({effect}, errors, {std::vector<double>(logs, 0.0)}));
    named.effects.push_back("effect_" + std::to_string(effect));
    named.on_rig.push_back(false);
    named.evidence.testable.push_back(true);
    named.evidence.contains.emplace_back();
  }
  return named;
}

/// Let a single effect leave another gap than the model without it: what it removes is its force.
inline void explain(diagnosis::NamedEvidence& named, int effect, double left) {
  diagnosis::HypothesisEvidence& single =
      named.evidence.hypotheses[static_cast<std::size_t>(diagnosis::Evidence::kFirstSingle + effect)];
  const double before = named.evidence.reEstimated().log_errors.front();
  single = fitted({effect}, std::vector<double>(single.log_errors.size(), left * left),
                  {std::vector<double>(single.log_errors.size(), before - left * left)});
}

}  // namespace rubber_suspension::test
