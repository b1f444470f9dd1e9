// Identification: variable projection over several starts, covariance of the best fit, undetermined combinations.
#include "rubber_suspension/fit/identification.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

#include "element/each.h"
#include "element/refuse.h"
#include "element/suggestion.h"
#include "fit/force_model.h"
#include "fit/residual_covariance.h"
#include "log/even_blocks.h"
#include "log/samples.h"
#include "numerics/gram.h"
#include "numerics/median.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::fit {
namespace {

using element::refuseIf;

constexpr std::size_t kFewestCompared = 50;  // samples
constexpr double kTail = 0.025;              // probability on either side of a 95 % interval
constexpr double kDeadBandInStandardDeviations = 6.0;
constexpr double kSmallestDeadBand = 1e-6;  // relative to the amplitude; a smaller one is rounding, not noise
constexpr double kSameResidual = 1e-4;      // two starts with a smaller relative difference ended at the same optimum

void checkLog(const log::Log& log, std::size_t number) {
  const std::size_t size = log.stamp.size();
  refuseIf(log.force.size() != size || log.displacement.size() != size,
           "log {}: displacement or force is missing for some samples; accepted: both for every sample", number);
  refuseIf(size < kFewestCompared, "log {}: {} samples are too few; accepted: at least {} samples", number, size,
           kFewestCompared);
  for (std::size_t i = 0; i < size; ++i) {
    refuseIf(!std::isfinite(log.displacement[i]) || !std::isfinite(log.force[i]), "log {}: sample {} is not finite",
             number, i);
    refuseIf(i > 0 && log.stamp[i] <= log.stamp[i - 1], "log {}: time does not increase at sample {}", number, i);
  }
  for (const auto& [name, values] : {std::pair("displacement", &log.displacement), {"force", &log.force}}) {
    const auto [low, high] = std::minmax_element(values->begin(), values->end());
    refuseIf(*low == *high, "log {0}: the {1} does not change; accepted: a log with a varying {1}", number, name);
  }
}

void checkHeld(const std::vector<element::ElementDescription>& elements, const std::vector<std::string>& held) {
  std::vector<std::string> names;
  for (const element::ElementDescription& element : elements) {
    for (const auto& [name, values] : element.values) {
      names.push_back(element.type + "." + name);
    }
  }
  for (const std::string& name : held) {
    refuseIf(std::find(names.begin(), names.end(), name) == names.end(),
             "hold: '{}' is not a parameter{}; accepted: {}", name, element::didYouMean(name, names),
             fmt::join(names, ", "));
  }
}

void checkRig(const std::vector<Eigen::MatrixXd>& rig, const std::vector<log::Log>& logs) {
  bool fits = rig.empty() || rig.size() == logs.size();
  for (std::size_t i = 0; fits && i < rig.size(); ++i) {
    fits = rig[i].cols() == 0 || rig[i].rows() == static_cast<Eigen::Index>(logs[i].size());
  }
  refuseIf(!fits, "rig: the columns and the logs differ in length; accepted: columns over all samples of each log");
}

// Returns the samples of all logs at which the force was measured.
Compared comparedOf(const std::vector<log::Log>& logs) {
  Compared compared;
  std::vector<double> force;
  Eigen::Index row = 0;
  for (const log::Log& log : logs) {
    std::vector<std::size_t> first = log::stretchesOf(log);
    first.push_back(log.size());
    for (std::size_t stretch = 0; stretch + 1 < first.size(); ++stretch) {
      const std::size_t before = force.size();
      for (std::size_t i = first[stretch]; i < first[stretch + 1]; ++i, ++row) {
        if (log::isCounted(log, i)) {
          compared.rows.push_back(row);
          force.push_back(log.force[i]);
        }
      }
      if (force.size() > before) {
        compared.runs.push_back(static_cast<Eigen::Index>(force.size() - before));
      }
    }
  }
  compared.force = Eigen::Map<const Eigen::VectorXd>(force.data(), static_cast<Eigen::Index>(force.size()));
  return compared;
}

// Returns one search coordinate of each nonlinear parameter.
template <class Coordinate>
Eigen::VectorXd eachOf(const ForceModel& model, Coordinate coordinate) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(model.nonlinear().size()));
  std::transform(model.nonlinear().begin(), model.nonlinear().end(), result.begin(), coordinate);
  return result;
}

std::vector<Eigen::VectorXd> startsOf(const ForceModel& model, const IdentificationOptions& options) {
  std::mt19937 generator(options.seed);
  std::vector<Eigen::VectorXd> starts = {eachOf(model, [](const Unknown& unknown) {
    return std::clamp(unknown.toSearch(unknown.given), unknown.lower, unknown.upper);
  })};
  // Without a nonlinear parameter the problem is convex, so that one start suffices.
  const std::size_t count = model.nonlinear().empty() ? 1 : static_cast<std::size_t>(std::max(1, options.starts));
  while (starts.size() < count) {
    starts.push_back(eachOf(model, [&](const Unknown& unknown) {
      const double part = static_cast<double>(generator()) / static_cast<double>(std::mt19937::max());
      return unknown.start_lower + part * (unknown.start_upper - unknown.start_lower);
    }));
  }
  return starts;
}

// Returns the best result of the searches from all starts.
Eigen::VectorXd searchAll(ForceModel& model, const IdentificationOptions& options, Identification& result) {
  const numerics::Limits limits{eachOf(model, [](const Unknown& unknown) { return unknown.lower; }),
                                eachOf(model, [](const Unknown& unknown) { return unknown.upper; })};
  std::vector<numerics::Optimum> optima;
  for (const Eigen::VectorXd& start : startsOf(model, options)) {
    ++result.starts;
    optima.push_back(numerics::searchLeast(model, start, limits));
    if (!std::isfinite(optima.back().cost)) {
      optima.pop_back();
    }
  }
  refuseIf(optima.empty(), "the simulated force is not finite at any starting point");
  const auto by_cost = [](const numerics::Optimum& a, const numerics::Optimum& b) { return a.cost < b.cost; };
  const numerics::Optimum& best = *std::min_element(optima.begin(), optima.end(), by_cost);
  const double limit = best.cost * (1.0 + kSameResidual) + 10.0 * model.rounding() * model.unit();
  result.starts_at_best = static_cast<int>(std::count_if(
      optima.begin(), optima.end(), [&](const numerics::Optimum& optimum) { return optimum.cost <= limit; }));
  return best.search;
}

std::string nameOf(const std::vector<element::ElementDescription>& elements, const Unknown& unknown) {
  const std::string& type = elements[unknown.element].type;
  int same = 0;
  int number = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    same += elements[i].type == type ? 1 : 0;
    number += elements[i].type == type && i <= unknown.element ? 1 : 0;
  }
  return (same > 1 ? fmt::format("{} {}", type, number) : type) + "." + unknown.name;
}

bool atLimit(const Unknown& unknown, double value) {
  const double x = unknown.toSearch(value);
  return x <= unknown.lower + 1e-6 || x >= unknown.upper - 1e-6;
}

IdentifiedParameter identified(const Unknown& unknown, double value, double standard_deviation, double quantile) {
  IdentifiedParameter result;
  result.index = static_cast<int>(unknown.element);
  result.name = unknown.name;
  result.unit = unknown.unit;
  result.given = unknown.given;
  result.value = value;
  const double reach = quantile * standard_deviation;
  if (unknown.logarithmic && value > 0.0) {
    result.lower = value * std::exp(-reach);
    result.upper = value * std::exp(reach);
  } else if (unknown.logarithmic) {  // the value is 0; the standard deviation is in units of the given value
    result.upper = reach * unknown.given;
  } else {
    const double unit = unknown.linear && value != 0.0 ? std::abs(value) : unknown.scale;
    result.lower = value - reach * unit;
    result.upper = value + reach * unit;
  }
  result.determined =
      value != 0.0 && standard_deviation < kUndetermined && (unknown.linear || !atLimit(unknown, value));
  return result;
}

// Returns the weights of a direction by name, of which the largest is 1. Columns of the rig are omitted.
UndeterminedDirection directionOf(const std::vector<std::string>& names, const Eigen::VectorXd& vector,
                                  double standard_deviation) {
  Eigen::Index largest = 0;
  vector.head(static_cast<Eigen::Index>(names.size())).cwiseAbs().maxCoeff(&largest);
  UndeterminedDirection result{standard_deviation, {}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double weight = vector[static_cast<Eigen::Index>(i)] / vector[largest];
    if (std::abs(weight) > 0.1) {
      result.weights.emplace_back(names[i], weight);
    }
  }
  return result;
}

std::vector<UndeterminedDirection> undeterminedOf(const std::vector<std::string>& names, const Covariance& covariance) {
  std::vector<UndeterminedDirection> result;
  for (const Eigen::VectorXd& vector : covariance.unseen) {
    result.push_back(directionOf(names, vector, HUGE_VAL));
  }
  const auto count = static_cast<Eigen::Index>(names.size());
  const numerics::Eigensystem eigen = numerics::eigensystem(covariance.matrix.topLeftCorner(count, count));
  for (Eigen::Index i = count - 1; i >= 0; --i) {
    const double standard_deviation = std::sqrt(std::max(0.0, eigen.values[i]));
    if (standard_deviation >= kUndetermined) {
      result.push_back(directionOf(names, eigen.vectors.col(i), standard_deviation));
    }
  }
  return result;
}

// Describes the parameters with their intervals, and the combinations that the logs hardly determine.
void describeParameters(const ForceModel& model, const ModelFit& fit, const Covariance& covariance, double quantile,
                        Identification& result) {
  std::vector<Unknown> unknowns = model.nonlinear();
  unknowns.insert(unknowns.end(), model.linear().begin(), model.linear().end());
  result.elements = model.elements();
  std::vector<std::string> names;
  for (const Unknown& unknown : unknowns) {
    const auto i = static_cast<Eigen::Index>(names.size());
    const double value =
        unknown.linear ? fit.coefficients[i - fit.search.size()] * unknown.given : unknown.toValue(fit.search[i]);
    result.parameters.push_back(identified(unknown, value, covariance.standardDeviation(i), quantile));
    result.parameters.back().element = model.elements()[unknown.element].type;
    result.elements[unknown.element].values[unknown.name] = {value};
    names.push_back(nameOf(model.elements(), unknown));
  }
  std::stable_sort(result.parameters.begin(), result.parameters.end(),
                   [](const auto& a, const auto& b) { return a.index < b.index; });
  result.undetermined = undeterminedOf(names, covariance);
}

// Adds a dead band to friction without one, so that noise of the displacement does not count as reversals.
void addDeadBands(std::vector<element::ElementDescription>& elements, const std::vector<log::Log>& logs,
                  std::vector<std::string>& notes) {
  const double negligible = kSmallestDeadBand * amplitudeOf(logs) / kDeadBandInStandardDeviations;
  double standard_deviation = 0.0;
  for (const log::Log& log : logs) {
    standard_deviation = std::max(standard_deviation, noiseStandardDeviation(log.displacement, negligible));
  }
  for (element::ElementDescription& element : elements) {
    if (element.type == "friction" && element.value("dead_band") == 0.0 && standard_deviation > 0.0) {
      element.values["dead_band"] = {kDeadBandInStandardDeviations * standard_deviation};
      notes.push_back(
          fmt::format("friction.dead_band set to {:.3g} m, {:g} standard deviations of the displacement's "
                      "noise",
                      kDeadBandInStandardDeviations * standard_deviation, kDeadBandInStandardDeviations));
    }
  }
}

// Removes elements without force, which cannot be constructed. The other elements keep their order.
void dropElementsWithoutForce(Identification& result) {
  std::vector<int> new_index(result.elements.size(), -1);
  std::vector<element::ElementDescription> kept;
  for (std::size_t i = 0; i < result.elements.size(); ++i) {
    const bool zero = std::any_of(result.parameters.begin(), result.parameters.end(), [&](const auto& parameter) {
      return parameter.index == static_cast<int>(i) && parameter.value == 0.0;
    });
    if (zero) {
      result.notes.push_back(fmt::format("{} {} has no force in the fit and was removed from the elements",
                                         result.elements[i].type, i + 1));
    } else {
      new_index[i] = static_cast<int>(kept.size());
      kept.push_back(result.elements[i]);
    }
  }
  result.elements = kept;
  for (IdentifiedParameter& parameter : result.parameters) {
    parameter.index = new_index[static_cast<std::size_t>(parameter.index)];
  }
}

void describeResiduals(Identification& result, const Eigen::VectorXd& residual, const Eigen::VectorXd& force) {
  const auto count = static_cast<double>(force.size());
  result.residual = std::sqrt(residual.squaredNorm() / count);
  result.relative_residual = gap::gapOfResidual(residual, gap::standardDeviation(force));
  if (result.relative_residual > 0.02 && result.independent_samples < count / 50.0) {
    result.notes.push_back(
        "the residuals are strongly correlated in time: the model lacks an effect, whose error the intervals do not "
        "include; use the command diagnose to find the effect");
  }
}

// Describes values and uncertainties of the parameters of the best fit, at which the model was evaluated last.
void describeFit(Identification& result, ForceModel& model, const ModelFit& fit, const Compared& compared) {
  const Eigen::VectorXd residual = model.residual();
  const Autoregression noise = fitAutoregression(residual, compared.runs);
  const auto count = static_cast<double>(residual.size());
  model.differentiate(fit);
  const Eigen::MatrixXd products = ForceModel::ofParameters(fit, numerics::gramOf(model.columns()));
  Covariance covariance = covarianceOf(
      products, ForceModel::ofParameters(fit, projectedCovariance(model.takeColumns(), compared.runs, noise)));
  result.independent_samples = count / std::max(1.0, correlationFactor(noise, residual.squaredNorm() / count));
  // Student's distribution is used because the variance is estimated, too. Its degrees of freedom are the independent
  // samples minus the number of parameters.
  const double left = std::max(1.0, result.independent_samples - static_cast<double>(products.cols()));
  covariance.matrix *= result.independent_samples / left;
  const double quantile = boost::math::quantile(boost::math::complement(boost::math::students_t(left), kTail));
  describeParameters(model, fit, covariance, quantile, result);
  describeResiduals(result, residual, compared.force);
}

}  // namespace

Identification identify(const std::vector<element::ElementDescription>& elements, const std::vector<log::Log>& logs,
                        const IdentificationOptions& options) {
  refuseIf(logs.empty(), "no log is given; accepted: at least one log");
  for (std::size_t i = 0; i < logs.size(); ++i) {
    checkLog(logs[i], i + 1);
  }
  const Compared compared = comparedOf(logs);
  refuseIf(compared.rows.size() < kFewestCompared,
           "{} samples with a measured force are too few; accepted: at least {}", compared.rows.size(),
           kFewestCompared);
  Identification result;
  std::vector<element::ElementDescription> completed = element::each(elements, element::complete);
  checkHeld(completed, options.held);
  addDeadBands(completed, logs, result.notes);
  checkRig(options.rig, logs);
  ForceModel model(completed, logs, compared, options.held, options.rig);
  refuseIf(model.nonlinear().empty() && model.linear().empty(),
           "all parameters are held; accepted: at least one parameter that is not held");
  const ModelFit best = model.fitAt(searchAll(model, options, result));
  result.force_offset = best.coefficients[static_cast<Eigen::Index>(model.linear().size())];
  describeFit(result, model, best, compared);
  dropElementsWithoutForce(result);
  return result;
}

double noiseStandardDeviation(const std::vector<double>& signal, double negligible) {
  constexpr int kHighestOrder = 10;
  constexpr double kNormalMedian = 0.6745;  // median of |x| of a standard normal variable
  std::vector<double> values = signal;
  std::vector<double> magnitude;
  double gain = 1.0;  // variance of the differences of white noise, the binomial coefficient (2 k over k)
  double smallest = HUGE_VAL;
  for (int order = 1; order <= kHighestOrder && values.size() > 1 && smallest > negligible; ++order) {
    magnitude.clear();
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
      values[i] = values[i + 1] - values[i];
      magnitude.push_back(std::abs(values[i]));
    }
    values.pop_back();
    gain *= (4.0 * order - 2.0) / order;
    smallest = std::min(smallest, numerics::medianIn(magnitude) / (kNormalMedian * std::sqrt(gain)));
  }
  return smallest > negligible && std::isfinite(smallest) ? smallest : 0.0;
}

}  // namespace rubber_suspension::fit
