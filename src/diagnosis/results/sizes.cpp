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
#include "numerics/symmetric.h"
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

// The sizes of one parameter vector.
struct Point {
  std::vector<Value> model;
  std::vector<Value> effects;
  std::vector<Value> written;
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

void addNumbers(const std::string& list, const Entries& entries, std::vector<Value>& values) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string entry = list + "[" + std::to_string(i) + "]";
    for (const auto& [key, numbers] : entries[i].values) {
      const std::string unit = unitOf(element::findElementType(entries[i].type)->parameters, key);
      for (std::size_t j = 0; j < numbers.size(); ++j) {
        values.push_back({{"", io::numberPlace(entry, key, numbers.size() == 1 ? -1 : static_cast<int>(j))},
                          unit,
                          numbers[j],
                          false});
      }
    }
  }
}

// Every number of a component file.
std::vector<Value> writtenValues(const io::ComponentDescription& description) {
  std::vector<Value> values;
  for (const auto& [name, value] : description.specification().values()) {
    values.push_back(
        {{"", "specification." + name}, unitOf(estimation::specificationParameters(), name), value, false});
  }
  if (description.model() == estimation::Model::elements) {
    addNumbers("elements", description.elements(), values);
  }
  addNumbers("add", description.add, values);
  return values;
}

class Resampling {
 public:
  Resampling(const fit::HypothesisFitter& fitter, const FittedLaw& fitted, const std::vector<double>& form_error,
             const std::vector<std::string>& effects, const DiagnosisOptions& options)
      : fitter_(fitter),
        fitted_(fitted),
        hypothesis_(fitted.law.hypothesis()),
        effects_(effects),
        options_(options),
        generator_(options.seed),
        blocks_(fitter.linearise(hypothesis_, fitted.fit.parameters, {}, options.threads)) {
    Eigen::Index first = fitter.model().size();
    for (std::size_t m = 0; m < form_error.size(); ++m) {
      const auto size = static_cast<Eigen::Index>(fitted.law.members[m].size());
      addMistakes(first, size, form_error[m]);
      first += size;
    }
  }

  Sizes run() {
    const Point best = pointAt(fitted_.fit.parameters);
    const Eigen::VectorXd rest = step(blocks_.sum);  // 0 but for what the fit's last step left
    std::uniform_int_distribution<std::size_t> pick(0, blocks_.gram.size() - 1);
    for (int i = 0; i < options_.resamplings; ++i) {
      Eigen::MatrixXd sum = blocks_.prior;
      for (std::size_t b = 0; b < blocks_.gram.size(); ++b) {
        sum += blocks_.gram[pick(generator_)];
      }
      collect(step(sum) - rest + mistake());
    }
    const Point configured = pointOfModel(Eigen::VectorXd::Zero(fitter_.model().size()));
    return {sized(best.model, configured.model, false), sized(best.effects, {}, true),
            sized(best.written, configured.written, false)};
  }

 private:
  // The part of a form error of this size that a fit takes for numbers of the law: all directions that they span alike.
  void addMistakes(Eigen::Index first, Eigen::Index size, double form_error) {
    const auto system = numerics::eigensystem(blocks_.sum.block(first, first, size, size));
    for (Eigen::Index i = 0; i < size; ++i) {
      if (system.values[i] > 1e-9 * system.values[size - 1]) {
        Eigen::VectorXd direction = Eigen::VectorXd::Zero(blocks_.sum.cols() - 1);
        direction.segment(first, size) =
            form_error / std::sqrt(static_cast<double>(size) * system.values[i]) * system.vectors.col(i);
        mistakes_.push_back(std::move(direction));
      }
    }
  }

  Eigen::VectorXd mistake() {
    std::normal_distribution<double> normal;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(blocks_.sum.cols() - 1);
    for (const Eigen::VectorXd& direction : mistakes_) {
      sum += normal(generator_) * direction;
    }
    return sum;
  }

  Eigen::VectorXd step(const Eigen::MatrixXd& sum) const {
    Eigen::VectorXd lower;
    Eigen::VectorXd upper;
    fitter_.stepBounds(hypothesis_, fitted_.fit.parameters, sum.cols() - 1, lower, upper);
    return fit::solveAll(sum, lower, upper);
  }

  void collect(const Eigen::VectorXd& step) {
    fit::ParameterVector moved = fitted_.fit.parameters;
    const Eigen::Index own = moved.model.size();
    moved.model += step.head(own);
    moved.scales = (moved.scales + step.segment(own, moved.scales.size())).eval();
    for (Eigen::Index t = 0; t < moved.scales.size(); ++t) {  // the rest that is subtracted may lead out of the bounds
      const fit::BasisTerm& term = hypothesis_.terms[static_cast<std::size_t>(t)];
      moved.scales[t] = std::clamp(moved.scales[t], term.lower, term.upper);
    }
    try {
      const Point point = pointAt(moved);
      ++resamples_;
      for (const auto* values : {&point.model, &point.effects, &point.written}) {
        for (const Value& value : *values) {
          draws_[value.key].push_back(value.value);
        }
      }
    } catch (const std::invalid_argument&) {
      return;  // no specification has these values: no draw
    }
  }

  Point pointOfModel(const Eigen::VectorXd& model) const {
    const io::ComponentDescription description = fitter_.model().apply(model);
    return {modelValues(description), {}, writtenValues(description)};
  }

  Point pointAt(const fit::ParameterVector& parameters) const {
    io::ComponentDescription description = fitter_.model().apply(parameters.model);
    Point point{modelValues(description), {}, {}};
    const std::vector<Entries> entries = fitted_.law.at(parameters.scales);
    for (std::size_t m = 0; m < entries.size(); ++m) {
      for (const HeadlineValue& value : headlineValuesOf(entries[m])) {
        point.effects.push_back({{effects_[m], value.name}, value.unit, value.value, value.is_scale});
      }
      description.add.insert(description.add.end(), entries[m].begin(), entries[m].end());
    }
    point.written = writtenValues(description);
    return point;
  }

  // An effect that a resample leaves out altogether has the size 0 in it.
  std::vector<SizedValue> sized(const std::vector<Value>& best, const std::vector<Value>& configured,
                                bool may_vanish) const {
    std::vector<SizedValue> result;
    for (const Value& value : best) {
      SizedValue size;
      std::tie(size.owner, size.name) = value.key;
      size.unit = value.unit;
      size.value = value.value;
      const auto found = std::find_if(configured.begin(), configured.end(),
                                      [&](const Value& other) { return other.key == value.key; });
      size.configured = found == configured.end() ? size.configured : found->value;
      predict(value, may_vanish, size);
      result.push_back(std::move(size));
    }
    return result;
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
  const FittedLaw& fitted_;
  const fit::Hypothesis hypothesis_;
  const std::vector<std::string>& effects_;
  const DiagnosisOptions& options_;
  std::mt19937 generator_;
  const fit::BlockGrams blocks_;
  std::vector<Eigen::VectorXd> mistakes_;  // each of standard deviation 1
  std::map<Key, std::vector<double>> draws_;
  std::size_t resamples_ = 0;
};

}  // namespace

Sizes sizesOf(const fit::HypothesisFitter& fitter, const FittedLaw& fitted, const std::vector<double>& form_error,
              const std::vector<std::string>& effects, const DiagnosisOptions& options) {
  return Resampling(fitter, fitted, form_error, effects, options).run();
}

}  // namespace rubber_suspension::diagnosis
