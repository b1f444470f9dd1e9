// Identification: variable projection over several starts, covariance of the best fit, what the log does not show.
#include "rubber_suspension/fit/identification.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

#include "element/suggestion.h"
#include "fit/fit_method.h"
#include "fit/force_model.h"
#include "fit/noise.h"
#include "fit/product_fit.h"
#include "fit/residual_covariance.h"
#include "fit/residual_fit.h"
#include "log/even_blocks.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::fit {
namespace {

constexpr double kTail = 0.025;  // on either side of a 95 % interval
constexpr double kDeadBandInStandardDeviations = 6.0;
constexpr double kSmallestDeadBand = 1e-6;  // relative to the amplitude; below it is rounding, not noise
constexpr double kRankTolerance = 1e-12;    // of eigenvalues of the correlation form of J'J
// Share of the force's sum of squares; a cost below is left to the residuals. Products know the gradient to 1e-15 of
// |column| |force|, and white noise moves it by |column| sqrt(cost/N): at this limit and for N = 1e6 samples the former
// is 1e-7 of the latter, so that columns may have a condition of 1e5 before a hundredth of a standard deviation is
// lost.
constexpr double kSmallestByProducts = 1e-10;
constexpr double kSameResidual = 1e-4;  // relative, by which starts count as ended at the same optimum

void checkLog(const log::Log& log, std::size_t number) {
  const auto fail = [&](const std::string& reason) {
    throw std::invalid_argument(fmt::format("log {}: {}", number, reason));
  };
  const std::size_t size = log.stamp.size();
  if (log.force.size() != size || log.displacement.size() != size) {
    fail("needs displacement and force for every sample");
  }
  if (size < 50) {
    fail(fmt::format("{} samples are too few; accepted: at least 50", size));
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (!std::isfinite(log.displacement[i]) || !std::isfinite(log.force[i])) {
      fail(fmt::format("sample {} is not finite", i));
    }
    if (i > 0 && log.stamp[i] <= log.stamp[i - 1]) {
      fail(fmt::format("time does not increase at sample {}", i));
    }
  }
  for (const auto* values : {&log.displacement, &log.force}) {
    const auto [low, high] = std::minmax_element(values->begin(), values->end());
    if (*low == *high) {
      fail(values == &log.force ? "the force does not change" : "the displacement does not change");
    }
  }
}

void checkHeld(const std::vector<element::ElementDescription>& elements, const std::vector<std::string>& held) {
  std::string accepted;
  std::vector<std::string> names;
  for (const element::ElementDescription& element : elements) {
    for (const auto& [name, values] : element.values) {
      names.push_back(element.type + "." + name);
    }
  }
  for (const std::string& name : names) {
    accepted += (accepted.empty() ? "" : ", ") + name;
  }
  for (const std::string& name : held) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw std::invalid_argument(fmt::format("hold: '{}' is not a parameter{}; accepted: {}", name,
                                              element::didYouMean(name, names), accepted));
    }
  }
}

void checkRig(const std::vector<Eigen::MatrixXd>& rig, const std::vector<log::Log>& logs) {
  bool fits = rig.empty() || rig.size() == logs.size();
  for (std::size_t i = 0; fits && i < rig.size(); ++i) {
    fits = rig[i].cols() == 0 || rig[i].rows() == static_cast<Eigen::Index>(logs[i].size());
  }
  if (!fits) {
    throw std::invalid_argument("rig: needs columns over the samples of each log");
  }
}

// Noise is taken as independent of that before a time gap.
void addRuns(const log::Log& log, std::vector<Eigen::Index>& runs) {
  std::vector<std::size_t> first = log::stretchesOf(log);
  first.push_back(log.size());
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    runs.push_back(static_cast<Eigen::Index>(first[i + 1] - first[i]));
  }
}

Eigen::VectorXd stackedForce(const std::vector<log::Log>& logs) {
  std::vector<double> all;
  for (const log::Log& log : logs) {
    all.insert(all.end(), log.force.begin(), log.force.end());
  }
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

Eigen::VectorXd startAsGiven(const ForceModel& model) {
  Eigen::VectorXd start(static_cast<Eigen::Index>(model.nonlinear().size()));
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    const Unknown& unknown = model.nonlinear()[static_cast<std::size_t>(i)];
    start[i] = unknown.toSearch(std::clamp(unknown.given, unknown.lower, unknown.upper));
  }
  return start;
}

Eigen::VectorXd randomStart(const ForceModel& model, std::mt19937& generator) {
  Eigen::VectorXd start(static_cast<Eigen::Index>(model.nonlinear().size()));
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    const Unknown& unknown = model.nonlinear()[static_cast<std::size_t>(i)];
    const double part = static_cast<double>(generator()) / static_cast<double>(std::mt19937::max());
    const double low = unknown.toSearch(unknown.start_lower);
    start[i] = low + part * (unknown.toSearch(unknown.start_upper) - low);
  }
  return start;
}

std::vector<Eigen::VectorXd> startsOf(const ForceModel& model, const IdentificationOptions& options) {
  std::mt19937 generator(options.seed);
  std::vector<Eigen::VectorXd> starts = {startAsGiven(model)};
  // Without a nonlinear unknown the problem is convex and one start tells all.
  const std::size_t count = model.nonlinear().empty() ? 1 : static_cast<std::size_t>(std::max(1, options.starts));
  while (starts.size() < count) {
    starts.push_back(randomStart(model, generator));
  }
  return starts;
}

struct Searches {
  Optimum best;
  int at_best = 0;
};

Limits limitsOf(const ForceModel& model) {
  const auto size = static_cast<Eigen::Index>(model.nonlinear().size());
  Limits limits{Eigen::VectorXd(size), Eigen::VectorXd(size)};
  for (Eigen::Index i = 0; i < size; ++i) {
    const Unknown& unknown = model.nonlinear()[static_cast<std::size_t>(i)];
    limits.lower[i] = unknown.toSearch(unknown.lower);
    limits.upper[i] = unknown.toSearch(unknown.upper);
  }
  return limits;
}

Searches searchFrom(const std::vector<Eigen::VectorXd>& starts, const Limits& limits, FitMethod& method) {
  Searches searches;
  std::vector<double> costs;
  for (const Eigen::VectorXd& start : starts) {
    const Optimum optimum = searchLeast(method, start, limits);
    if (std::isfinite(optimum.cost)) {
      costs.push_back(optimum.cost);
      if (costs.size() == 1 || optimum.cost < searches.best.cost) {
        searches.best = optimum;
      }
    }
  }
  if (costs.empty()) {
    throw std::invalid_argument("the simulated force is not finite from any start");
  }
  const double limit = searches.best.cost * (1.0 + kSameResidual) + 10.0 * method.rounding() * method.unit();
  searches.at_best = static_cast<int>(std::count_if(costs.begin(), costs.end(), [&](double c) { return c <= limit; }));
  return searches;
}

// The result of the searches: the best fit, and what it knows of the parameters.
struct BestFit {
  ModelFit fit;
  Eigen::MatrixXd products;  // J'J of FitMethod's Jacobian J
  Autoregression noise;
  Eigen::MatrixXd noise_products;  // J'OJ, O being the covariance of the residuals
};

BestFit describeFit(FitMethod& method, const ModelFit& fit, const std::vector<Eigen::Index>& runs) {
  BestFit best{fit, method.jacobianProducts(fit), fitAutoregression(fit.residual, runs), {}};
  best.noise_products = best.noise.coefficients.empty() ? best.noise.innovation * best.products
                                                        : projectedCovariance(method.jacobian(fit), runs, best.noise);
  return best;
}

BestFit bestFit(ForceModel& model, const Eigen::VectorXd& force, const std::vector<log::Log>& logs,
                const std::vector<Eigen::Index>& runs, const IdentificationOptions& options, Identification& result) {
  const std::vector<Eigen::VectorXd> starts = startsOf(model, options);
  result.starts = static_cast<int>(starts.size());
  const Limits limits = limitsOf(model);
  ResidualFit by_residuals(model, force);
  if (!options.by_products || !options.rig.empty() || !ProductFit::appliesTo(model, logs)) {
    const Searches searches = searchFrom(starts, limits, by_residuals);
    result.starts_at_best = searches.at_best;
    return describeFit(by_residuals, by_residuals.fitAt(searches.best.search), runs);
  }
  ProductFit by_products(model, logs);
  const Searches searches = searchFrom(starts, limits, by_products);
  result.starts_at_best = searches.at_best;
  const ModelFit fit = by_products.fitAt(searches.best.search);
  if (fit.cost() > kSmallestByProducts * by_products.unit()) {
    return describeFit(by_products, fit, runs);
  }
  return describeFit(by_residuals, by_residuals.fitAt(searchLeast(by_residuals, fit.search, limits).search), runs);
}

// Covariance of the unknowns in the coordinates of the Jacobian, and directions that the log does not show at all.
struct Covariance {
  Eigen::MatrixXd matrix;
  std::vector<Eigen::VectorXd> unseen;
  double quantile = 1.96;  // of the parameters' standard deviations, for 95 %
};

// From the products J'J and J'OJ of the Jacobian, O being the covariance of the residuals.
Covariance covarianceOf(const Eigen::MatrixXd& products, const Eigen::MatrixXd& noise_products) {
  const Eigen::VectorXd length = products.diagonal().cwiseMax(0.0).cwiseSqrt();
  const double largest = length.maxCoeff();
  const Eigen::VectorXd inverse =
      length.unaryExpr([&](double x) { return x > 1e-14 * largest ? 1.0 / x : 1.0 / (1e-14 * largest); });
  const numerics::Eigensystem eigen = numerics::eigensystem(inverse.asDiagonal() * products * inverse.asDiagonal());
  Eigen::MatrixXd pseudo_inverse = Eigen::MatrixXd::Zero(length.size(), length.size());
  Covariance covariance;
  for (Eigen::Index i = 0; i < length.size(); ++i) {
    const Eigen::VectorXd direction = eigen.vectors.col(i);
    if (eigen.values[i] > kRankTolerance * eigen.values.maxCoeff()) {
      pseudo_inverse += direction * direction.transpose() / eigen.values[i];
    } else {
      covariance.unseen.push_back((inverse.asDiagonal() * direction).normalized());
    }
  }
  const Eigen::MatrixXd outer = inverse.asDiagonal() * pseudo_inverse * inverse.asDiagonal();
  covariance.matrix = outer * noise_products * outer.transpose();
  return covariance;
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

void setInterval(IdentifiedParameter& parameter, const Unknown& unknown, double coefficient_sign,
                 double standard_deviation, double quantile) {
  const double reach = quantile * standard_deviation;
  if (unknown.logarithmic && parameter.value > 0.0) {
    parameter.lower = parameter.value * std::exp(-reach);
    parameter.upper = parameter.value * std::exp(reach);
  } else if (unknown.logarithmic) {  // at zero: the standard deviation counts in the given value
    parameter.lower = 0.0;
    parameter.upper = reach * unknown.given;
  } else {
    const double unit = coefficient_sign != 0.0 ? std::abs(parameter.value) : unknown.scale;
    parameter.lower = parameter.value - reach * unit;
    parameter.upper = parameter.value + reach * unit;
  }
  parameter.determined = parameter.value != 0.0 && standard_deviation < kUndetermined;
}

bool atLimit(const Unknown& unknown, double value) {
  const double x = unknown.toSearch(value);
  return x <= unknown.toSearch(unknown.lower) + 1e-6 || x >= unknown.toSearch(unknown.upper) - 1e-6;
}

// Puts together what the best fit says.
class Summary {
 public:
  Summary(ForceModel& model, const ModelFit& fit, const Covariance& covariance)
      : model_(model), fit_(fit), covariance_(covariance) {}

  void describe(Identification& result) const {
    result.elements = model_.elements();
    for (std::size_t i = 0; i < model_.nonlinear().size(); ++i) {
      const Unknown& unknown = model_.nonlinear()[i];
      const double value = unknown.toValue(fit_.search[static_cast<Eigen::Index>(i)]);
      add(result, unknown, value, static_cast<Eigen::Index>(i), 0.0);
      result.parameters.back().determined &= !atLimit(unknown, value);
    }
    for (std::size_t i = 0; i < model_.linear().size(); ++i) {
      const Unknown& unknown = model_.linear()[i];
      const double coefficient = fit_.coefficients[static_cast<Eigen::Index>(i)];
      add(result, unknown, coefficient * unknown.given, fit_.search.size() + static_cast<Eigen::Index>(i), coefficient);
    }
    std::stable_sort(result.parameters.begin(), result.parameters.end(),
                     [](const auto& a, const auto& b) { return a.index < b.index; });
    addDirections(result);
  }

 private:
  void add(Identification& result, const Unknown& unknown, double value, Eigen::Index column,
           double coefficient) const {
    result.elements[unknown.element].values[unknown.name] = {value};
    IdentifiedParameter parameter;
    parameter.element = model_.elements()[unknown.element].type;
    parameter.index = static_cast<int>(unknown.element);
    parameter.name = unknown.name;
    parameter.unit = unknown.unit;
    parameter.value = value;
    parameter.given = unknown.given;
    const bool unseen = std::any_of(covariance_.unseen.begin(), covariance_.unseen.end(),
                                    [&](const Eigen::VectorXd& v) { return std::abs(v[column]) > 1e-3; });
    const double standard_deviation = unseen ? HUGE_VAL : std::sqrt(std::max(0.0, covariance_.matrix(column, column)));
    setInterval(parameter, unknown, coefficient, standard_deviation, covariance_.quantile);
    result.parameters.push_back(parameter);
  }

  // Columns of the rig are no parameters.
  Eigen::Index parameters() const {
    return static_cast<Eigen::Index>(model_.nonlinear().size() + model_.linear().size());
  }

  // Weights of a direction by name, the largest 1.
  UndeterminedDirection direction(const Eigen::VectorXd& vector, double standard_deviation) const {
    const Eigen::Index count = parameters();
    Eigen::Index largest = 0;
    vector.head(count).cwiseAbs().maxCoeff(&largest);
    UndeterminedDirection result;
    result.standard_deviation = standard_deviation;
    for (Eigen::Index i = 0; i < count; ++i) {
      const double weight = vector[i] / vector[largest];
      if (std::abs(weight) > 0.1) {
        const auto at = static_cast<std::size_t>(i);
        const std::size_t nonlinear = model_.nonlinear().size();
        const Unknown& unknown = at < nonlinear ? model_.nonlinear()[at] : model_.linear()[at - nonlinear];
        result.weights.emplace_back(nameOf(model_.elements(), unknown), weight);
      }
    }
    return result;
  }

  void addDirections(Identification& result) const {
    for (const Eigen::VectorXd& vector : covariance_.unseen) {
      result.undetermined.push_back(direction(vector, HUGE_VAL));
    }
    const Eigen::Index count = parameters();
    if (count == 0) {
      return;
    }
    const numerics::Eigensystem eigen = numerics::eigensystem(covariance_.matrix.topLeftCorner(count, count));
    for (Eigen::Index i = count - 1; i >= 0; --i) {
      const double standard_deviation = std::sqrt(std::max(0.0, eigen.values[i]));
      if (standard_deviation >= kUndetermined) {
        result.undetermined.push_back(direction(eigen.vectors.col(i), standard_deviation));
      }
    }
  }

  ForceModel& model_;
  const ModelFit& fit_;
  const Covariance& covariance_;
};

double independentSamples(const Eigen::VectorXd& residual, const Autoregression& noise) {
  const auto count = static_cast<double>(residual.size());
  return count / std::max(1.0, correlationFactor(noise, residual.squaredNorm() / count));
}

// The fit takes as many independent samples out of the residuals as it has unknowns, and their variance is an estimate
// itself: Student's distribution with the samples that are left.
void allowForFewSamples(Covariance& covariance, double independent_samples) {
  const auto unknowns = static_cast<double>(covariance.matrix.rows());
  const double left = std::max(1.0, independent_samples - unknowns);
  covariance.matrix *= independent_samples / left;
  covariance.quantile = boost::math::quantile(boost::math::complement(boost::math::students_t(left), kTail));
}

// Gives friction without dead band one that keeps the noise of the displacement from being taken for reversals.
void addDeadBands(std::vector<element::ElementDescription>& elements, const std::vector<log::Log>& logs,
                  std::vector<std::string>& notes) {
  const double amplitude = scalesOf(logs).amplitude;
  const double negligible = kSmallestDeadBand * amplitude / kDeadBandInStandardDeviations;
  double standard_deviation = 0.0;
  for (const log::Log& log : logs) {
    if (noisierThan(log.displacement, negligible)) {
      standard_deviation = std::max(standard_deviation, noiseStandardDeviation(log.displacement));
    }
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

// Elements that the fit left without force cannot be built; the others keep their order.
void dropElementsWithoutForce(Identification& result) {
  std::vector<int> new_index(result.elements.size(), -1);
  std::vector<element::ElementDescription> kept;
  for (std::size_t i = 0; i < result.elements.size(); ++i) {
    const bool zero = std::any_of(result.parameters.begin(), result.parameters.end(), [&](const auto& parameter) {
      return parameter.index == static_cast<int>(i) && parameter.value == 0.0;
    });
    if (zero) {
      result.notes.push_back(
          fmt::format("{} {} was left without force and out of the elements", result.elements[i].type, i + 1));
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

void describeResiduals(Identification& result, const ModelFit& fit, const Eigen::VectorXd& force,
                       const Autoregression& noise) {
  const auto count = static_cast<double>(force.size());
  const double variance = fit.residual.squaredNorm() / count;
  result.residual = std::sqrt(variance);
  result.relative_residual = gap::gapOfResidual(fit.residual, gap::standardDeviation(force));
  result.independent_samples = independentSamples(fit.residual, noise);
  if (result.relative_residual > 0.02 && result.independent_samples < count / 50.0) {
    result.notes.push_back(
        "the residuals are strongly correlated in time: the model leaves something out that is not part of the "
        "intervals; the command diagnose tells what");
  }
}

}  // namespace

Identification identify(const std::vector<element::ElementDescription>& elements, const std::vector<log::Log>& logs,
                        const IdentificationOptions& options) {
  if (logs.empty()) {
    throw std::invalid_argument("no log given");
  }
  std::vector<Eigen::Index> runs;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    checkLog(logs[i], i + 1);
    addRuns(logs[i], runs);
  }
  Identification result;
  std::vector<element::ElementDescription> completed;
  for (const element::ElementDescription& element : elements) {
    completed.push_back(element::complete(element));
  }
  checkHeld(completed, options.held);
  addDeadBands(completed, logs, result.notes);
  checkRig(options.rig, logs);
  ForceModel model(completed, logs, options.held, options.rig);
  if (model.nonlinear().empty() && model.linear().empty()) {
    throw std::invalid_argument("no parameter is left to be found; all are held");
  }
  const Eigen::VectorXd force = stackedForce(logs);
  const BestFit best = bestFit(model, force, logs, runs, options, result);
  result.force_offset = best.fit.coefficients[static_cast<Eigen::Index>(model.linear().size())];
  Covariance covariance = covarianceOf(best.products, best.noise_products);
  allowForFewSamples(covariance, independentSamples(best.fit.residual, best.noise));
  Summary(model, best.fit, covariance).describe(result);
  describeResiduals(result, best.fit, force, best.noise);
  dropElementsWithoutForce(result);
  return result;
}

}  // namespace rubber_suspension::fit
