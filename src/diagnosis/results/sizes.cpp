// Computes sizes of effects and model parameters by resampling blocks of the logs.
#include "diagnosis/results/sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

#include "diagnosis/effect.h"
#include "element/each.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::diagnosis::results {
namespace {

using Key = std::pair<std::string, std::string>;  // owner and name

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Draw {
  double value;
  double weight;
};

bool isLess(const Draw& a, const Draw& b) { return a.value < b.value; }

// Returns a weighted quantile of draws in ascending order.
double quantile(const std::vector<Draw>& draws, double share) {
  double below = share * std::accumulate(draws.begin(), draws.end(), 0.0,
                                         [](double sum, const Draw& draw) { return sum + draw.weight; });
  for (const Draw& draw : draws) {
    below -= draw.weight;
    if (below < 0.0) {
      return draw.value;
    }
  }
  return draws.back().value;
}

// The total over several elements gets the key of a single element, because another draw may have only one element.
Key keyOf(const SizedValue& size) {
  const std::string total = "total_";
  return {size.owner, size.name.rfind(total, 0) == 0 ? size.name.substr(total.size()) : size.name};
}

std::string unitOf(const std::vector<element::ParameterInfo>& table, const std::string& name) {
  const element::ParameterInfo* const info = element::findParameter(table, name);
  return info == nullptr ? "1" : info->unit;
}

std::vector<SizedValue> modelValues(const io::ComponentDescription& description) {
  std::vector<SizedValue> values;
  for (const auto& [name, value] : description.specification().values()) {
    values.push_back({"specification", name, unitOf(estimation::specificationParameters(), name), kNone, value});
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
        values.push_back({owner, parameter.name, parameter.unit, kNone, found->second.front()});
      }
    }
  }
  return values;
}

void addNumbers(const std::string& list, const Entries& entries, std::vector<SizedValue>& values) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string entry = list + "[" + std::to_string(i) + "]";
    for (const auto& [key, numbers] : entries[i].values) {
      const std::string unit = unitOf(element::findElementType(entries[i].type)->parameters, key);
      for (std::size_t j = 0; j < numbers.size(); ++j) {
        const int place = numbers.size() == 1 ? -1 : static_cast<int>(j);
        values.push_back({"", io::numberPlace(entry, key, place), unit, kNone, numbers[j]});
      }
    }
  }
}

std::vector<SizedValue> writtenValues(const io::ComponentDescription& description) {
  std::vector<SizedValue> values;
  for (const auto& [name, value] : description.specification().values()) {
    const std::string unit = unitOf(estimation::specificationParameters(), name);
    values.push_back({"", "specification." + name, unit, kNone, value});
  }
  if (description.model() == estimation::Model::elements) {
    addNumbers("elements", description.elements(), values);
  }
  addNumbers("add", description.add, values);
  return values;
}

std::vector<std::string> effectsOf(const Law& law, const std::vector<fit::Candidate>& candidates) {
  return element::each(
      law.members, [&](const MemberLaw& member) { return candidates[static_cast<std::size_t>(member.member)].effect; });
}

class Resampling {
 public:
  Resampling(const fit::HypothesisFitter& fitter, const WeighedLaw& law, const std::vector<double>& form_error,
             const hypotheses::Search& search, const DiagnosisOptions& options)
      : fitter_(fitter),
        fitted_(law.fitted),
        weight_(law.odds / static_cast<double>(options.resamplings)),
        hypothesis_(fitted_.law.hypothesis()),
        effects_(effectsOf(fitted_.law, search.candidates)),
        excitation_(search.excitation),
        generator_(options.seed),
        blocks_(fitter_.linearise(hypothesis_, fitted_.fit.parameters, {}, options.threads)),
        best_(sizesAt(fitted_.fit.parameters)) {
    Eigen::Index first = fitter_.model().size();
    for (std::size_t m = 0; m < form_error.size(); ++m) {
      const auto size = static_cast<Eigen::Index>(fitted_.law.members[m].size());
      addFormErrorDirections(first, size, form_error[m]);
      first += size;
    }
    for (std::size_t b = 0; b < blocks_.gram.size(); ++b) {
      groups_[hypothesis_.free_in_log.any() ? blocks_.record[b] : 0].push_back(b);
    }
    draw(options.resamplings);
  }

  // Adds the draws of another law to the sizes that both laws have. Entries of the component file are skipped, because
  // the other law has another number at the same position.
  void add(const Resampling& other) {
    for (auto& [key, draws] : draws_) {
      const bool another = key.first.empty() && key.second.rfind("add[", 0) == 0;
      const auto found = another ? other.draws_.end() : other.draws_.find(key);
      if (found != other.draws_.end()) {
        const std::vector<Draw> more = other.all(found->first, found->second);
        draws = all(key, draws);
        draws.insert(draws.end(), more.begin(), more.end());
      }
    }
  }

  Sizes sizes() const {
    Sizes best = best_;
    const auto configured = fitter_.model().apply(Eigen::VectorXd::Zero(fitter_.model().size()));
    complete(modelValues(configured), best.model);
    complete({}, best.effects);
    complete(writtenValues(configured), best.written);
    return best;
  }

 private:
  void draw(int count) {
    const Eigen::VectorXd rest = step(blocks_.sum);  // nearly 0: the step that remains to the minimum of the fit
    for (int i = 0; i < count; ++i) {
      Eigen::MatrixXd sum = blocks_.prior;
      moveKnown(sum);
      addResampled(sum);
      moveBy(formError(), sum);
      collect(step(sum) - rest);
    }
  }

  // Adds as many blocks as there are, drawn with replacement. If a hypothesis has per-log parameters, the common part
  // of an effect scatters from log to log. Logs are then drawn first, and blocks within each drawn log.
  void addResampled(Eigen::MatrixXd& sum) {
    const auto any = [&](std::size_t size) {
      return std::uniform_int_distribution<std::size_t>(0, size - 1)(generator_);
    };
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const auto& [log, blocks] = *std::next(groups_.begin(), static_cast<std::ptrdiff_t>(any(groups_.size())));
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        sum += blocks_.gram[blocks[any(blocks.size())]];
      }
    }
  }

  // Draws prior values of the model, so that numbers that no log determines keep their prior uncertainty.
  void moveKnown(Eigen::MatrixXd& sum) {
    const Eigen::MatrixXd slopes = fitter_.model().departureSlopes(fitted_.fit.parameters.model);
    std::normal_distribution<double> normal;
    const Eigen::VectorXd off = Eigen::VectorXd::NullaryExpr(
        slopes.rows(), [&](Eigen::Index) { return std::pow(fitter_.oneDeviation(), 2) * normal(generator_); });
    const Eigen::VectorXd moment = slopes.transpose() * off;
    sum.rightCols<1>().head(moment.size()) += moment;
    sum.bottomRows<1>().head(moment.size()) += moment.transpose();
  }

  // Spreads a form error equally over all directions that the parameters of the law span.
  void addFormErrorDirections(Eigen::Index first, Eigen::Index size, double form_error) {
    if (size == 0) {
      return;  // such a law has no numbers, for example a contact without preload
    }
    const auto system = numerics::eigensystem(blocks_.sum.block(first, first, size, size));
    for (Eigen::Index i = 0; i < size; ++i) {
      if (system.values[i] > 1e-9 * system.values[size - 1]) {
        Eigen::VectorXd direction = Eigen::VectorXd::Zero(blocks_.sum.cols() - 1);
        direction.segment(first, size) =
            form_error / std::sqrt(static_cast<double>(size) * system.values[i]) * system.vectors.col(i);
        form_errors_.push_back(std::move(direction));
      }
    }
  }

  Eigen::VectorXd formError() {
    std::normal_distribution<double> normal;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(blocks_.sum.cols() - 1);
    for (const Eigen::VectorXd& direction : form_errors_) {
      sum += normal(generator_) * direction;
    }
    return sum;
  }

  // Moves the minimum of normal equations by a step. If a bound prevents a part of the step, other numbers compensate.
  static void moveBy(const Eigen::VectorXd& step, Eigen::MatrixXd& sum) {
    const Eigen::Index count = step.size();
    const Eigen::VectorXd moment = sum.topLeftCorner(count, count) * step;
    sum.rightCols<1>().head(count) += moment;
    sum.bottomRows<1>().head(count) += moment.transpose();
  }

  Eigen::VectorXd step(const Eigen::MatrixXd& sum) const {
    return fit::solve(sum, fitter_.stepBounds(hypothesis_, fitted_.fit.parameters, sum.cols() - 1));
  }

  void collect(const Eigen::VectorXd& step) {
    fit::ParameterVector moved = fitted_.fit.parameters;
    const Eigen::Index own = moved.model.size();
    moved.model += step.head(own);
    moved.scales = (moved.scales + step.segment(own, moved.scales.size())).eval();
    for (Eigen::Index t = 0; t < moved.scales.size(); ++t) {  // subtracting the remaining step may exceed the bounds
      const fit::BasisTerm& term = hypothesis_.terms[static_cast<std::size_t>(t)];
      moved.scales[t] = std::clamp(moved.scales[t], term.lower, term.upper);
    }
    try {
      const Sizes drawn = sizesAt(moved);
      ++resamples_;
      for (const auto* sizes : {&drawn.model, &drawn.effects, &drawn.written}) {
        for (const SizedValue& size : *sizes) {
          draws_[keyOf(size)].push_back({size.value, weight_});
        }
      }
    } catch (const std::invalid_argument&) {
      return;  // no specification has these values, so that there is no draw
    }
  }

  Sizes sizesAt(const fit::ParameterVector& parameters) {
    io::ComponentDescription description = fitter_.model().apply(parameters.model);
    Sizes sizes;
    sizes.model = modelValues(description);
    const std::vector<Entries> entries = fitted_.law.at(parameters.scales);
    for (std::size_t m = 0; m < entries.size(); ++m) {
      const auto sized = effectNamed(effects_[m]).sizes;
      for (const HeadlineValue& value :
           sized != nullptr ? sized(entries[m], excitation_) : headlineValuesOf(entries[m])) {
        sizes.effects.push_back({effects_[m], value.name, value.unit, kNone, value.value});
        if (value.is_scale) {
          may_vanish_.insert(keyOf(sizes.effects.back()));
        }
      }
      description.add.insert(description.add.end(), entries[m].begin(), entries[m].end());
    }
    sizes.written = writtenValues(description);
    return sizes;
  }

  void complete(const std::vector<SizedValue>& configured, std::vector<SizedValue>& sizes) const {
    for (SizedValue& size : sizes) {
      const auto found = std::find_if(configured.begin(), configured.end(), [&](const SizedValue& other) {
        return other.owner == size.owner && other.name == size.name;
      });
      size.configured = found == configured.end() ? kNone : found->value;
      predict(size);
    }
  }

  // A resample without the effect contributes a size of 0.
  std::vector<Draw> all(const Key& key, std::vector<Draw> draws) const {
    draws.resize(may_vanish_.count(key) > 0 ? std::max(draws.size(), resamples_) : draws.size(), {0.0, weight_});
    return draws;
  }

  void predict(SizedValue& size) const {
    const auto found = draws_.find(keyOf(size));
    if (found == draws_.end()) {
      size.interval_95 = {size.value, size.value};
      return;
    }
    std::vector<Draw> draws = all(found->first, found->second);
    std::sort(draws.begin(), draws.end(), isLess);
    size.interval_95 = {std::min(size.value, quantile(draws, 0.025)), std::max(size.value, quantile(draws, 0.975))};
    // Draws beyond a bound were moved to the bound, so that an interval that ends at an extreme draw ends at a bound.
    const double least = draws.front().value;
    const double most = draws.back().value;
    size.at_bound = {least < most && size.interval_95[0] == least, least < most && size.interval_95[1] == most};
  }

  const fit::HypothesisFitter& fitter_;
  const FittedLaw& fitted_;
  const double weight_;  // weight of each draw
  const fit::Hypothesis hypothesis_;
  const std::vector<std::string> effects_;  // effects of the hypothesis
  const fit::Excitation& excitation_;
  std::mt19937 generator_;
  const fit::BlockGrams blocks_;
  std::map<int, std::vector<std::size_t>> groups_;  // blocks that are resampled together, by log
  std::set<Key> may_vanish_;                        // keys of sizes that are 0 without the effect
  const Sizes best_;
  std::vector<Eigen::VectorXd> form_errors_;  // each scaled by one standard deviation of the form error
  std::map<Key, std::vector<Draw>> draws_;
  std::size_t resamples_ = 0;
};

}  // namespace

Sizes sizesOf(const fit::HypothesisFitter& fitter, const std::vector<WeighedLaw>& laws,
              const std::vector<double>& form_error, const hypotheses::Search& search,
              const DiagnosisOptions& options) {
  Resampling first(fitter, laws.front(), form_error, search, options);
  for (std::size_t l = 1; l < laws.size(); ++l) {
    first.add(Resampling(fitter, laws[l], form_error, search, options));
  }
  return first.sizes();
}

}  // namespace rubber_suspension::diagnosis::results
