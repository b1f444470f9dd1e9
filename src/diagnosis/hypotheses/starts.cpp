// Where the fits of effects start.
#include "diagnosis/hypotheses/starts.h"

#include <algorithm>
#include <utility>

namespace rubber_suspension::diagnosis {
namespace {

constexpr int kSingleIterations = 6;
constexpr int kFurtherIterations = 3;
constexpr int kAloneIterations = 4;
constexpr double kClearlyBetter = 0.99;  // of a score
// A logarithm of a model parameter: far enough for a second start from the configured ones.
constexpr double kFar = 0.2;

void keepBetter(fit::Fit fit, FittedHypothesis& fitted) {
  if (fitted.fit.blocks.empty() || fit.score() < fitted.fit.score()) {
    fitted.fit = std::move(fit);
  }
}

}  // namespace

void fitSingle(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated, FittedHypothesis& single) {
  const fit::Hypothesis& hypothesis = single.hypothesis;
  if (hypothesis.terms.empty()) {
    single.fit = re_estimated.fit;
    return;
  }
  const fit::ParameterVector configured = fitter.configured(hypothesis);
  fit::ParameterVector start = configured;
  start.model = re_estimated.fit.parameters.model;
  keepBetter(fitter.fit(hypothesis, start, kSingleIterations), single);
  const bool far = start.largestChange() > kFar;
  const bool additive = hypothesis.isAdditive();
  if (far && !additive) {
    keepBetter(fitter.fit(hypothesis, configured, kSingleIterations), single);
  }
  if (far || !additive) {
    start = fitter.scalesAlone(hypothesis, configured, additive ? 1 : kAloneIterations);
    keepBetter(fitter.fit(hypothesis, start, kSingleIterations), single);
  }
}

void fitGains(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated, FittedHypothesis& single) {
  FittedHypothesis common = single;
  common.hypothesis.free_in_log.gain = false;
  fitSingle(fitter, re_estimated, common);
  keepBetter(fitter.fit(single.hypothesis, common.fit.parameters, kSingleIterations), single);
  keepBetter(fitter.fit(single.hypothesis, fitter.configured(single.hypothesis), kSingleIterations), single);
  if (single.fit.score() > kClearlyBetter * common.fit.score()) {
    single = std::move(common);
  }
}

void fitFurther(const fit::HypothesisFitter& fitter, const std::vector<fit::Candidate>& candidates,
                const FittedHypothesis& from, FittedHypothesis& further) {
  const fit::Hypothesis& hypothesis = further.hypothesis;
  const std::vector<int>& fitted = from.hypothesis.members;
  fit::ParameterVector start = fitter.configured(hypothesis);
  std::vector<bool> active(hypothesis.terms.size(), true);
  start.model = from.fit.parameters.model;
  std::size_t place = 0;
  std::size_t place_from = 0;
  for (const int member : hypothesis.members) {
    const bool known = std::find(fitted.begin(), fitted.end(), member) != fitted.end();
    for (const fit::BasisTerm& term : candidates[static_cast<std::size_t>(member)].terms) {
      if (known) {
        const double scale = from.fit.parameters.scales[static_cast<Eigen::Index>(place_from++)];
        start.scales[static_cast<Eigen::Index>(place)] = scale;
        active[place] = term.additive || scale != 0.0;
      }
      ++place;
    }
  }
  keepBetter(fitter.fit(hypothesis, start, kFurtherIterations, active), further);
  if (start.largestChange() > kFar && hypothesis.isAdditive()) {
    start = fitter.scalesAlone(hypothesis, fitter.configured(hypothesis), 1);
    keepBetter(fitter.fit(hypothesis, start, kSingleIterations), further);
  }
}

}  // namespace rubber_suspension::diagnosis
