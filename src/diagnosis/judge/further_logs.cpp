// Mean squares over all logs.
#include "diagnosis/judge/further_logs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace rubber_suspension::diagnosis {
namespace {

// How the logs of the fit and unseen ones share the weight.
struct Shares {
  double fitted;
  double unseen;

  double rootMeanSquare(double of_fitted, double of_unseen) const {
    return std::sqrt(fitted * of_fitted * of_fitted + unseen * of_unseen * of_unseen);
  }
};

double weightOf(const std::vector<gap::PartError>& parts) {
  double weight = 0.0;
  for (const gap::PartError& part : parts) {
    weight += part.weight;
  }
  return weight;
}

Shares sharesOf(const Evidence& evidence) {
  const std::set<int> logs(evidence.block_logs.begin(), evidence.block_logs.end());
  const double fitted = std::max(1.0, static_cast<double>(logs.size()));
  const std::vector<gap::PartError>& parts = evidence.reEstimated().unseen->parts;
  const double unseen = parts.empty() ? 1.0 : 1.0 + parts.back().log;
  return {fitted / (fitted + unseen), unseen / (fitted + unseen)};
}

// The parts as blocks of logs after those of the fit.
void appendBlocks(const Shares& shares, Evidence& evidence) {
  const std::vector<gap::PartError>& parts = evidence.reEstimated().unseen->parts;
  for (double& weight : evidence.block_weights) {
    weight *= shares.fitted;
  }
  const int first = 1 + *std::max_element(evidence.block_logs.begin(), evidence.block_logs.end());
  const double total = weightOf(parts);
  for (const gap::PartError& part : parts) {
    evidence.block_logs.push_back(first + part.log);
    evidence.block_weights.push_back(part.weight / total * shares.unseen);
  }
  for (HypothesisEvidence& hypothesis : evidence.hypotheses) {
    for (const gap::PartError& part : hypothesis.unseen->parts) {
      hypothesis.block_errors.push_back(part.error);
    }
  }
}

}  // namespace

Evidence withFurtherLogs(Evidence evidence) {
  if (!evidence.has_unseen_logs) {
    return evidence;
  }
  const Shares shares = sharesOf(evidence);
  double floor = std::numeric_limits<double>::infinity();
  for (const HypothesisEvidence& hypothesis : evidence.hypotheses) {
    floor = std::min(floor, hypothesis.unseen->noise_floor);
  }
  evidence.noise_floor = shares.rootMeanSquare(evidence.noise_floor, floor);
  for (HypothesisEvidence& hypothesis : evidence.hypotheses) {
    hypothesis.held_out = shares.rootMeanSquare(hypothesis.held_out, hypothesis.unseen->gap);
  }
  if (!evidence.block_logs.empty()) {
    appendBlocks(shares, evidence);
  }
  return evidence;
}

}  // namespace rubber_suspension::diagnosis
