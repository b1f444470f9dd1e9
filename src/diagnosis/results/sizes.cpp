// Sizes of effects and model parameters, resampled by blocks.
#include "diagnosis/results/sizes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "diagnosis/results/augmented.h"
#include "fit/bounded_least_squares.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::diagnosis {
namespace {

using Key = std::pair<std::string, std::string>;  // owner and name

struct Value {
  Key key;
  std::string unit;
  double value = 0.0;
  bool is_scale = false;  // nothing of the effect is left at 0
};

// What one parameter vector amounts to.
struct Point {
  std::vector<Value> model;
  std::vector<Value> effects;
};

std::string unitOf(const std::vector<element::ParameterInfo>& table, const std::string& name) {
  const element::ParameterInfo* const info = element::findParameter(table, name);
  return info == nullptr ? "1" : info->unit;
}

std::vector<Value> modelValues(const io::ComponentDescription& description) {
  std::vector<Value> values;
  for (const auto& [name, value] : description.specification().values()) {
    values.push_back({{"specification", name}, unitOf(estimation::specificationParameters(), name), value, false});
  }
  if (!values.empty()) {
    return values;
  }
  std::map<std::string, int> count;
  for (const element::ElementDescription& element : description.elements()) {
    const int number = ++count[element.type];
    const std::string owner = element.type + (number > 1 ? " " + std::to_string(number) : "");
    for (const element::ParameterInfo& parameter : element::findElementType(element.type)->parameters) {
      const auto found = element.values.find(parameter.name);
      if (found != element.values.end() && element::isFree(parameter, found->second) && found->second.size() == 1) {
        values.push_back({{owner, parameter.name}, parameter.unit, found->second.front(), false});
      }
    }
  }
  return values;
}

class Resampling {
 public:
  Resampling(const fit::HypothesisFitter& fitter, const std::vector<fit::Candidate>& candidates,
             const FittedHypothesis& fitted)
      : fitter_(fitter), candidates_(candidates), fitted_(fitted) {}

  Sizes run(const DiagnosisOptions& options) {
    const Point best = pointAt(fitted_.fit.parameters);
    const fit::BlockGrams blocks = fitter_.linearise(fitted_.hypothesis, fitted_.fit.parameters, {}, options.threads);
    const Eigen::VectorXd rest = step(blocks.sum);  // 0 but for what the fit's last step left
    std::mt19937 generator(options.seed);
    std::uniform_int_distribution<std::size_t> pick(0, blocks.gram.size() - 1);
    for (int i = 0; i < options.resamplings; ++i) {
      Eigen::MatrixXd sum = blocks.prior;
      for (std::size_t b = 0; b < blocks.gram.size(); ++b) {
        sum += blocks.gram[pick(generator)];
      }
      collect(step(sum) - rest);
    }
    return {sized(best.model, false), sized(best.effects, true)};
  }

 private:
  Eigen::VectorXd step(const Eigen::MatrixXd& sum) const {
    const Eigen::Index columns = sum.cols() - 1;
    Eigen::VectorXd lower;
    Eigen::VectorXd upper;
    fitter_.stepBounds(fitted_.hypothesis, fitted_.fit.parameters, columns, lower, upper);
    return fit::boundedLeastSquares(sum.topLeftCorner(columns, columns), sum.col(columns).head(columns), lower, upper);
  }

  void collect(const Eigen::VectorXd& step) {
    fit::ParameterVector moved = fitted_.fit.parameters;
    const Eigen::Index own = moved.model.size();
    moved.model += step.head(own);
    moved.scales = (moved.scales + step.segment(own, moved.scales.size())).eval();
    for (Eigen::Index t = 0; t < moved.scales.size(); ++t) {  // the rest that is subtracted may lead out of the bounds
      const fit::BasisTerm& term = fitted_.hypothesis.terms[static_cast<std::size_t>(t)];
      moved.scales[t] = std::clamp(moved.scales[t], term.lower, term.upper);
    }
    try {
      const Point point = pointAt(moved);
      ++resamples_;
      for (const auto* values : {&point.model, &point.effects}) {
        for (const Value& value : *values) {
          draws_[value.key].push_back(value.value);
        }
      }
    } catch (const std::invalid_argument&) {
      return;  // no specification has these values: no draw
    }
  }

  Point pointAt(const fit::ParameterVector& parameters) const {
    Point point;
    point.model = modelValues(fitter_.model().apply(parameters.model));
    Eigen::Index first = 0;
    for (const int member : fitted_.hypothesis.members) {
      const fit::Candidate& candidate = candidates_[static_cast<std::size_t>(member)];
      const auto count = static_cast<Eigen::Index>(candidate.terms.size());
      FittedHypothesis alone;
      alone.hypothesis.terms.assign(fitted_.hypothesis.terms.begin() + first,
                                    fitted_.hypothesis.terms.begin() + first + count);
      alone.fit.parameters.scales = parameters.scales.segment(first, count);
      for (const HeadlineValue& value : shortHeadlineOf(entriesOf(alone))) {
        point.effects.push_back({{candidate.effect, value.name}, value.unit, value.value, value.is_scale});
      }
      first += count;
    }
    return point;
  }

  // An effect that a resample leaves out altogether has the size 0 in it.
  std::vector<SizedValue> sized(const std::vector<Value>& best, bool may_vanish) const {
    const std::map<Key, double> configured = configuredValues();
    std::vector<SizedValue> result;
    for (const Value& value : best) {
      SizedValue size;
      std::tie(size.owner, size.name) = value.key;
      size.unit = value.unit;
      size.value = value.value;
      if (const auto found = configured.find(value.key); found != configured.end()) {
        size.configured = found->second;
      }
      predict(value, may_vanish, size);
      result.push_back(std::move(size));
    }
    return result;
  }

  std::map<Key, double> configuredValues() const {
    std::map<Key, double> values;
    const Eigen::VectorXd unchanged = Eigen::VectorXd::Zero(fitter_.model().size());
    for (const Value& value : modelValues(fitter_.model().apply(unchanged))) {
      values[value.key] = value.value;
    }
    return values;
  }

  void predict(const Value& value, bool may_vanish, SizedValue& size) const {
    const auto found = draws_.find(value.key);
    if (found == draws_.end()) {
      size.interval_95 = {value.value, value.value};
      return;
    }
    std::vector<double> draws = found->second;
    if (may_vanish && value.is_scale) {
      draws.resize(std::max(draws.size(), resamples_), 0.0);
    }
    std::sort(draws.begin(), draws.end());
    const auto at = [&](double share) {
      return draws[static_cast<std::size_t>(std::lround(share * static_cast<double>(draws.size() - 1)))];
    };
    size.interval_95 = {std::min(value.value, at(0.025)), std::max(value.value, at(0.975))};
    // A bound gathers all draws that would lie beyond it.
    const bool spread = draws.front() < draws.back();
    size.at_bound = {spread && size.interval_95[0] == draws.front(), spread && size.interval_95[1] == draws.back()};
  }

  const fit::HypothesisFitter& fitter_;
  const std::vector<fit::Candidate>& candidates_;
  const FittedHypothesis& fitted_;
  std::map<Key, std::vector<double>> draws_;
  std::size_t resamples_ = 0;
};

}  // namespace

Sizes sizesOf(const fit::HypothesisFitter& fitter, const std::vector<fit::Candidate>& candidates,
              const FittedHypothesis& fitted, const DiagnosisOptions& options) {
  return Resampling(fitter, candidates, fitted).run(options);
}

}  // namespace rubber_suspension::diagnosis
