// Chooses the parameters from which the fits of effects start.
#include "diagnosis/hypotheses/starts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace rubber_suspension::diagnosis::hypotheses {
namespace {

constexpr int kLeastIterations = 6;
constexpr int kToldIterations = 20;  // for a start that the logs suggest, which is far from the configured values
constexpr int kFurtherIterations = 3;
constexpr int kAloneIterations = 4;
constexpr int kZeroIterations = 2;
constexpr double kClearlyBetter = 0.99;  // a clearly better fit has at most this share of the score of the other one
// Change of the logarithm of a model parameter above which a fit also starts from the configured values.
constexpr double kFar = 0.2;

// Returns the number of iterations in which a parameter can reach its bound, at least kLeastIterations.
int singleIterations(const fit::HypothesisFitter& fitter) {
  const double farthest = std::log(fitter.model().largestRatio());
  return std::max(kLeastIterations, static_cast<int>(std::ceil(farthest / fit::kLongestStep)));
}

void keepBetter(FittedHypothesis fitted, FittedHypothesis& best) {
  if (best.fit.blocks.empty() || fitted.fit.score() < best.fit.score()) {
    best = std::move(fitted);
  }
}

// Replaces the offsets of single logs by a common offset, unless separate offsets fit clearly better.
void keepOneOffset(const fit::HypothesisFitter& fitter, const fit::FitLimits& limits, FittedHypothesis& fitted) {
  if (!fitted.hypothesis.free_in_log.offset || fitted.fit.gap > limits.reach) {
    return;
  }
  FittedHypothesis one = fitted;
  one.hypothesis.free_in_log.offset = false;
  one.fit = fitter.fit(one.hypothesis, fitted.fit.parameters, {kZeroIterations, limits.reach});
  if (kClearlyBetter * one.fit.score() <= fitted.fit.score()) {
    fitted = std::move(one);
  }
}

// Fits a hypothesis from a start. Offsets of the displacement are free if the force at the start depends on them. If
// only the force after the fit depends on them, they are freed for a second fit.
void fitFrom(const fit::HypothesisFitter& fitter, const fit::Hypothesis& hypothesis, const fit::ParameterVector& start,
             const fit::FitLimits& limits, FittedHypothesis& best) {
  FittedHypothesis fitted{hypothesis, {}};
  fitter.freeZeros(start, fitted.hypothesis);
  fitted.fit = fitter.fit(fitted.hypothesis, start, limits);
  if (!fitted.hypothesis.free_in_log.by_zero && fitted.fit.gap <= limits.reach) {
    FittedHypothesis with_zeros = fitted;
    fitter.freeZeros(fitted.fit.parameters, with_zeros.hypothesis);
    if (with_zeros.hypothesis.free_in_log.by_zero) {
      with_zeros.fit = fitter.fit(with_zeros.hypothesis, fitted.fit.parameters, {kZeroIterations, limits.reach});
      keepBetter(std::move(with_zeros), fitted);
    }
  }
  keepOneOffset(fitter, limits, fitted);
  keepBetter(std::move(fitted), best);
}

// Returns the index of a term in another hypothesis, or nothing if that hypothesis lacks the term.
std::optional<Eigen::Index> placeIn(const fit::Hypothesis& other, const fit::TermPlace& term) {
  const auto found = std::find(other.places.begin(), other.places.end(), term);
  return found == other.places.end() ? std::nullopt : std::optional(found - other.places.begin());
}

// For each term, returns true if a fit may change it: the term is new, additive or not 0. All other terms remain at 0,
// because a fit would have to simulate their force.
std::vector<bool> mayMove(const FittedHypothesis& from, const fit::Hypothesis& hypothesis,
                          const fit::ParameterVector& start) {
  std::vector<bool> active;
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    active.push_back(!placeIn(from.hypothesis, hypothesis.places[t]) || hypothesis.terms[t].additive ||
                     start.scales[static_cast<Eigen::Index>(t)] != 0.0);
  }
  return active;
}

// Returns a start with the model parameters of another fit and the scales of the terms that both contain.
fit::ParameterVector taken(const fit::HypothesisFitter& fitter, const FittedHypothesis& from,
                           const fit::Hypothesis& hypothesis) {
  fit::ParameterVector start = fitter.configured(hypothesis);
  start.model = from.fit.parameters.model;
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    if (const auto place = placeIn(from.hypothesis, hypothesis.places[t])) {
      start.scales[static_cast<Eigen::Index>(t)] = from.fit.parameters.scales[*place];
    }
  }
  return start;
}

}  // namespace

void fitSingle(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
               const fit::ParameterVector& start, double reach, FittedHypothesis& single) {
  const fit::Hypothesis hypothesis = single.hypothesis;
  if (hypothesis.terms.empty()) {
    single.fit = re_estimated.fit;
    return;
  }
  const fit::FitLimits limits{singleIterations(fitter), reach};
  const fit::ParameterVector configured = fitter.configured(hypothesis);
  fit::ParameterVector none = configured;
  none.model = re_estimated.fit.parameters.model;
  const bool promising = fitter.gapAt(hypothesis, start) < re_estimated.fit.gap;
  fitFrom(fitter, hypothesis, promising ? start : none, limits, single);
  fit::ParameterVector told = none;
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    told.scales[static_cast<Eigen::Index>(t)] = hypothesis.terms[t].start;
  }
  if (!told.scales.isZero(0.0)) {
    fitFrom(fitter, hypothesis, told, {kToldIterations, reach}, single);
  }
  const bool far = none.largestChange() > kFar;
  const bool additive = hypothesis.isAdditive();
  if (single.fit.gap > reach || (!far && additive)) {
    return;
  }
  if (far && !additive) {
    fitFrom(fitter, hypothesis, configured, limits, single);
  }
  const fit::ParameterVector alone = fitter.scalesAlone(hypothesis, configured, additive ? 1 : kAloneIterations);
  fitFrom(fitter, hypothesis, alone, limits, single);
}

void fitGains(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated, double reach,
              FittedHypothesis& single) {
  const fit::FitLimits limits{singleIterations(fitter), reach};
  FittedHypothesis common = single;
  common.hypothesis.free_in_log.gain = false;
  fitFrom(fitter, common.hypothesis, fitter.configured(common.hypothesis), limits, common);
  if (single.hypothesis.free_in_log.gain) {
    fit::ParameterVector other_values = fitter.configured(single.hypothesis);
    other_values.model = re_estimated.fit.parameters.model;
    for (const fit::ParameterVector& start : {common.fit.parameters, other_values}) {
      keepBetter({single.hypothesis, fitter.fit(single.hypothesis, start, limits)}, single);
    }
    if (single.fit.score() <= kClearlyBetter * std::min(common.fit.score(), re_estimated.fit.score())) {
      return;
    }
  }
  single = std::move(common);
}

void fitFurther(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, const fit::ParameterVector& start,
                double reach, FittedHypothesis& further) {
  further.hypothesis.free_in_log.by_factor = from.hypothesis.free_in_log.by_factor;
  const fit::Hypothesis hypothesis = further.hypothesis;
  const fit::ParameterVector as_fitted = taken(fitter, from, hypothesis);
  const bool promising = fitter.gapAt(hypothesis, start) < from.fit.gap;
  const fit::ParameterVector& first = promising ? start : as_fitted;
  // Model parameters and the gains of logs can compensate each other, so that a fit needs many steps.
  const int iterations = hypothesis.free_in_log.gain ? singleIterations(fitter) : kFurtherIterations;
  fitFrom(fitter, hypothesis, first, {iterations, reach, mayMove(from, hypothesis, first)}, further);
  if (further.fit.gap <= reach && from.fit.parameters.largestChange() > kFar && hypothesis.isAdditive()) {
    fitFrom(fitter, hypothesis, fitter.scalesAlone(hypothesis, fitter.configured(hypothesis), 1),
            {singleIterations(fitter), reach}, further);
  }
}

void fitBeyond(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, FittedHypothesis& larger) {
  larger.hypothesis.free_in_log.by_zero = from.hypothesis.free_in_log.by_zero;
  larger.hypothesis.free_in_log.by_factor = from.hypothesis.free_in_log.by_factor;
  const fit::ParameterVector start = taken(fitter, from, larger.hypothesis);
  fit::FitLimits limits{kFurtherIterations};
  limits.active = mayMove(from, larger.hypothesis, start);
  limits.about_its_end = true;
  larger.fit = fitter.fit(larger.hypothesis, start, limits);
}

FittedHypothesis withFactors(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, double reach) {
  FittedHypothesis with{from.hypothesis, {}};
  fitter.freeFactors(from.fit.parameters, with.hypothesis);
  const bool promising = fitter.gapAt(with.hypothesis, from.fit.parameters) <= reach;
  with.fit = promising ? fitter.fit(with.hypothesis, from.fit.parameters, {kFurtherIterations, reach}) : from.fit;
  if (promising) {  // fits again, with factors on the friction that this fit found
    fitter.freeFactors(with.fit.parameters, with.hypothesis);
    with.fit = fitter.fit(with.hypothesis, with.fit.parameters, {kZeroIterations, reach});
  }
  return with;
}

void fitCurved(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, double reach,
               FittedHypothesis& curved) {
  curved.hypothesis.free_in_log.by_factor = from.hypothesis.free_in_log.by_factor;
  const fit::ParameterVector start = taken(fitter, from, curved.hypothesis);
  fitFrom(fitter, curved.hypothesis, start, {singleIterations(fitter), reach, mayMove(from, curved.hypothesis, start)},
          curved);
}

}  // namespace rubber_suspension::diagnosis::hypotheses
