// Numbers of a search for the judgement.
#include "diagnosis/hypotheses/search_evidence.h"

#include <algorithm>

#include "diagnosis/hypotheses/sets.h"

namespace rubber_suspension::diagnosis {
namespace {

HypothesisEvidence evidenceOf(const FittedHypothesis& fitted) {
  HypothesisEvidence evidence;
  evidence.members = fitted.hypothesis.members;
  evidence.terms = fitted.hypothesis.terms.size();
  evidence.free_trends = fitted.hypothesis.free_in_log.trend;
  evidence.free_gains = fitted.hypothesis.free_in_log.gain;
  evidence.history = fitted.hypothesis.history;
  evidence.sensor = fitted.hypothesis.sensor;
  evidence.last_resort = fitted.hypothesis.last_resort;
  evidence.like_parameters = fitted.hypothesis.like_parameters;
  evidence.held_out = fitted.fit.held_out;
  evidence.penalty = fitted.fit.penalty;
  evidence.largest_change = fitted.fit.parameters.largestChange();
  for (const gap::PartError& block : fitted.fit.blocks) {
    evidence.block_errors.push_back(block.error);
  }
  return evidence;
}

// Gains of logs that are not all within a tolerance of one.
bool differ(const std::vector<double>& gains, double tolerance) {
  if (gains.empty()) {
    return false;
  }
  const auto [least, most] = std::minmax_element(gains.begin(), gains.end());
  return *most - *least > 2.0 * tolerance;
}

}  // namespace

Evidence evidenceOf(const Search& search) {
  Evidence evidence;
  HypothesisEvidence configured;
  configured.held_out = search.configured_gap;
  evidence.hypotheses = {configured, evidenceOf(search.re_estimated)};
  for (const FittedHypothesis* fitted : search.withEffects()) {
    evidence.hypotheses.push_back(evidenceOf(*fitted));
  }
  for (const gap::PartError& block : search.re_estimated.fit.blocks) {
    evidence.block_logs.push_back(block.log);
    evidence.block_weights.push_back(block.weight);
  }
  evidence.testable = search.testable;
  evidence.contains = containedIn(search.candidates);
  evidence.element_level = search.element_level.held_out;
  evidence.noise_floor = search.noise;
  evidence.discretisation = search.discretisation;
  return evidence;
}

void markGainsWithinTolerance(const io::RigTolerance& tolerance, const Search& search, const Criteria& criteria,
                              Evidence& evidence) {
  const double most = io::kTolerated * std::max(tolerance.value, criteria.values_err_by);
  for (std::size_t h = Evidence::kFirstSingle; h < evidence.hypotheses.size(); ++h) {
    const FittedHypothesis& fitted = search.at(static_cast<int>(h));
    HypothesisEvidence& hypothesis = evidence.hypotheses[h];
    if (fitted.hypothesis.free_in_log.gain) {
      hypothesis.like_parameters = !differ(fitted.fit.gains, io::kTolerated * tolerance.value);
    }
    if (hypothesis.like_parameters && hypothesis.members.size() == 1) {
      hypothesis.within_tolerance = fitted.fit.parameters.scales.array().log1p().abs().maxCoeff() <= most;
    }
  }
}

}  // namespace rubber_suspension::diagnosis
