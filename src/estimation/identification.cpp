// Identification: variable projection over several starts, covariance of the best fit, what the log does not show.
#include "rubber_suspension/estimation/identification.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>

#include "force_model.h"
#include "linear_least_squares.h"
#include "residual_covariance.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension {
namespace {

constexpr double kTail = 0.025;                     // on either side of a 95 % interval
const double kUndetermined = std::log(2.0) / 1.96;  // deviation of ln(value) whose interval is a factor of 2
constexpr double kDeadBandInDeviations = 6.0;
constexpr double kSmallestDeadBand = 1e-6;  // relative to the amplitude; below it is rounding, not noise
constexpr double kRankTolerance = 1e-12;    // of eigenvalues of the correlation form of J'J
constexpr double kSameResidual = 1e-4;      // relative, by which starts count as ended at the same optimum

void checkMeasurement(const Measurement& measurement, std::size_t number) {
  const auto fail = [&](const std::string& reason) {
    throw std::invalid_argument(fmt::format("log {}: {}", number, reason));
  };
  const std::size_t size = measurement.stamp.size();
  if (measurement.force.size() != size || measurement.displacement.size() != size) {
    fail("needs displacement and force for every sample");
  }
  if (size < 50) {
    fail(fmt::format("{} samples are too few; accepted: at least 50", size));
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (!std::isfinite(measurement.displacement[i]) || !std::isfinite(measurement.force[i])) {
      fail(fmt::format("sample {} is not finite", i));
    }
    if (i > 0 && measurement.stamp[i] <= measurement.stamp[i - 1]) {
      fail(fmt::format("time does not increase at sample {}", i));
    }
  }
  for (const auto* values : {&measurement.displacement, &measurement.force}) {
    const auto [low, high] = std::minmax_element(values->begin(), values->end());
    if (*low == *high) {
      fail(values == &measurement.force ? "the force does not change" : "the displacement does not change");
    }
  }
}

void checkHeld(const std::vector<ElementDescription>& elements, const std::vector<std::string>& held) {
  std::string accepted;
  std::vector<std::string> names;
  for (const ElementDescription& element : elements) {
    for (const auto& [name, values] : element.values) {
      names.push_back(element.type + "." + name);
    }
  }
  for (const std::string& name : names) {
    accepted += (accepted.empty() ? "" : ", ") + name;
  }
  for (const std::string& name : held) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw std::invalid_argument(fmt::format("hold: '{}' is not a parameter; accepted: {}", name, accepted));
    }
  }
}

Eigen::VectorXd stackedForce(const std::vector<Measurement>& measurements) {
  std::vector<double> all;
  for (const Measurement& measurement : measurements) {
    all.insert(all.end(), measurement.force.begin(), measurement.force.end());
  }
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

// One fit: where the search ended, the eliminated coefficients there, and what is left.
struct Fit {
  Eigen::VectorXd search;
  Eigen::VectorXd coefficients;
  Eigen::VectorXd residual;

  double cost() const { return residual.squaredNorm(); }
};

Fit fitAt(ForceModel& model, const Eigen::VectorXd& force, const Eigen::VectorXd& search) {
  model.evaluate(search);
  Fit fit;
  fit.search = search;
  fit.coefficients = solveLeastSquares(model.basis(), force - model.rest(), model.signedColumns());
  fit.residual = force - model.rest() - model.basis() * fit.coefficients;
  return fit;
}

// What is left of columns once the basis has taken its share, without the columns of the basis that are held at zero.
Eigen::MatrixXd withoutBasis(const ForceModel& model, const Eigen::VectorXd& coefficients,
                             const Eigen::MatrixXd& columns) {
  std::vector<Eigen::Index> taken;
  for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
    if (coefficients[i] != 0.0 || model.signedColumns()[static_cast<std::size_t>(i)]) {
      taken.push_back(i);
    }
  }
  Eigen::MatrixXd basis(model.size(), static_cast<Eigen::Index>(taken.size()));
  for (std::size_t i = 0; i < taken.size(); ++i) {
    const auto column = model.basis().col(taken[i]);
    const double length = column.norm();
    basis.col(static_cast<Eigen::Index>(i)) = column / (length > 0.0 ? length : 1.0);
  }
  const Eigen::MatrixXd gram = basis.transpose() * basis;
  const Eigen::MatrixXd moment = basis.transpose() * columns;
  return columns - basis * gram.completeOrthogonalDecomposition().solve(moment);
}

// The projected residual as Ceres calls it, made free of units. Its Jacobian is that of L. Kaufman, BIT 15 (1975)
// 49-57: the term that it leaves out is across the residual, so the gradient is exact, and so is the optimum.
class ProjectedResidual final : public ceres::CostFunction {
 public:
  ProjectedResidual(ForceModel& model, const Eigen::VectorXd& force)
      : model_(model), force_(force), unit_(force.norm()) {
    set_num_residuals(static_cast<int>(force.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(model.nonlinear().size()));
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    const auto count = static_cast<Eigen::Index>(model_.nonlinear().size());
    const Eigen::Map<const Eigen::VectorXd> search(parameters[0], count);
    if (fit_.search.size() != count || fit_.search != search) {  // the Jacobian is asked for where the residual was
      fit_ = fitAt(model_, force_, search);
    }
    const Fit& fit = fit_;
    Eigen::Map<Eigen::VectorXd>(residuals, force_.size()) = fit.residual / unit_;
    if (!fit.residual.allFinite()) {
      return false;
    }
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::MatrixXd derivatives(force_.size(), count);
      for (Eigen::Index i = 0; i < count; ++i) {
        derivatives.col(i) = model_.derivative(fit.search, i, fit.coefficients);
      }
      using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      Eigen::Map<RowMajor>(jacobians[0], force_.size(), count) =
          withoutBasis(model_, fit.coefficients, derivatives) / -unit_;
      return derivatives.allFinite();
    }
    return true;
  }

 private:
  ForceModel& model_;
  const Eigen::VectorXd& force_;
  double unit_;
  mutable Fit fit_;  // where it was evaluated last, like the model
};

Fit search(ForceModel& model, const Eigen::VectorXd& force, const Eigen::VectorXd& start) {
  if (start.size() == 0) {
    return fitAt(model, force, start);
  }
  Eigen::VectorXd x = start;
  ceres::Problem problem;
  problem.AddResidualBlock(new ProjectedResidual(model, force), nullptr, x.data());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Unknown& unknown = model.nonlinear()[static_cast<std::size_t>(i)];
    problem.SetParameterLowerBound(x.data(), static_cast<int>(i), unknown.toSearch(unknown.lower));
    problem.SetParameterUpperBound(x.data(), static_cast<int>(i), unknown.toSearch(unknown.upper));
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 60;
  options.function_tolerance = 1e-10;
  options.parameter_tolerance = 1e-9;
  options.gradient_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  options.max_num_line_search_step_size_iterations = 0;  // steps beyond a bound are cut; no search along each step
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return fitAt(model, force, x);
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

struct Searches {
  Fit best;
  int starts = 0;
  int at_best = 0;
};

Searches searchFromSeveralStarts(ForceModel& model, const Eigen::VectorXd& force,
                                 const IdentificationOptions& options) {
  std::mt19937 generator(options.seed);
  Searches searches;
  std::vector<double> costs;
  // Without a nonlinear unknown the problem is convex and one start tells all.
  searches.starts = model.nonlinear().empty() ? 1 : std::max(1, options.starts);
  for (int i = 0; i < searches.starts; ++i) {
    const Fit fit = search(model, force, i == 0 ? startAsGiven(model) : randomStart(model, generator));
    if (fit.residual.allFinite()) {
      costs.push_back(fit.cost());
      if (costs.size() == 1 || fit.cost() < searches.best.cost()) {
        searches.best = fit;
      }
    }
  }
  if (costs.empty()) {
    throw std::invalid_argument("the simulated force is not finite from any start");
  }
  const double limit = searches.best.cost() * (1.0 + kSameResidual) + 1e-20 * force.squaredNorm();
  searches.at_best = static_cast<int>(std::count_if(costs.begin(), costs.end(), [&](double c) { return c <= limit; }));
  return searches;
}

// How the value of a coefficient follows from its relative change: the coefficient itself, or 1 where it is zero.
double relativeUnit(double coefficient) { return coefficient != 0.0 ? std::abs(coefficient) : 1.0; }

// Derivatives of the force: by search coordinates of the nonlinear unknowns, then by relative changes of the linear
// ones and of the offset.
Eigen::MatrixXd jacobianAt(ForceModel& model, const Fit& fit) {
  const Eigen::Index nonlinear = fit.search.size();
  Eigen::MatrixXd jacobian(model.size(), nonlinear + fit.coefficients.size());
  for (Eigen::Index i = 0; i < nonlinear; ++i) {
    jacobian.col(i) = model.derivative(fit.search, i, fit.coefficients);
  }
  model.evaluate(fit.search);
  for (Eigen::Index i = 0; i < fit.coefficients.size(); ++i) {
    jacobian.col(nonlinear + i) = relativeUnit(fit.coefficients[i]) * model.basis().col(i);
  }
  return jacobian;
}

// Covariance of the unknowns in the coordinates of the Jacobian, and directions that the log does not show at all.
struct Covariance {
  Eigen::MatrixXd matrix;
  std::vector<Eigen::VectorXd> unseen;
  double quantile = 1.96;  // of the parameters' deviations, for 95 %
};

Covariance covarianceOf(const Eigen::MatrixXd& jacobian, const std::vector<Eigen::Index>& runs,
                        const Autoregression& noise) {
  const Eigen::VectorXd length = jacobian.colwise().norm().transpose();
  const double largest = length.maxCoeff();
  const Eigen::VectorXd inverse =
      length.unaryExpr([&](double x) { return x > 1e-14 * largest ? 1.0 / x : 1.0 / (1e-14 * largest); });
  const Eigen::MatrixXd scaled = jacobian * inverse.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled.transpose() * scaled);
  Eigen::MatrixXd pseudo_inverse = Eigen::MatrixXd::Zero(length.size(), length.size());
  Covariance covariance;
  for (Eigen::Index i = 0; i < length.size(); ++i) {
    const Eigen::VectorXd direction = eigen.eigenvectors().col(i);
    if (eigen.eigenvalues()[i] > kRankTolerance * eigen.eigenvalues().maxCoeff()) {
      pseudo_inverse += direction * direction.transpose() / eigen.eigenvalues()[i];
    } else {
      covariance.unseen.push_back((inverse.asDiagonal() * direction).normalized());
    }
  }
  const Eigen::MatrixXd outer = inverse.asDiagonal() * pseudo_inverse;
  covariance.matrix = outer * projectedCovariance(scaled, runs, noise) * outer.transpose();
  return covariance;
}

std::string nameOf(const std::vector<ElementDescription>& elements, const Unknown& unknown) {
  const std::string& type = elements[unknown.element].type;
  int same = 0;
  int number = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    same += elements[i].type == type ? 1 : 0;
    number += elements[i].type == type && i <= unknown.element ? 1 : 0;
  }
  return (same > 1 ? fmt::format("{} {}", type, number) : type) + "." + unknown.name;
}

void setInterval(IdentifiedParameter& parameter, const Unknown& unknown, double coefficient_sign, double deviation,
                 double quantile) {
  const double reach = quantile * deviation;
  if (unknown.logarithmic && parameter.value > 0.0) {
    parameter.lower = parameter.value * std::exp(-reach);
    parameter.upper = parameter.value * std::exp(reach);
  } else if (unknown.logarithmic) {  // at zero: the deviation counts in the given value
    parameter.lower = 0.0;
    parameter.upper = reach * unknown.given;
  } else {
    const double unit = coefficient_sign != 0.0 ? std::abs(parameter.value) : unknown.scale;
    parameter.lower = parameter.value - reach * unit;
    parameter.upper = parameter.value + reach * unit;
  }
  parameter.determined = parameter.value != 0.0 && deviation < kUndetermined;
}

bool atLimit(const Unknown& unknown, double value) {
  const double x = unknown.toSearch(value);
  return x <= unknown.toSearch(unknown.lower) + 1e-6 || x >= unknown.toSearch(unknown.upper) - 1e-6;
}

// Puts together what the best fit says.
class Summary {
 public:
  Summary(ForceModel& model, const Fit& fit, const Covariance& covariance)
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
    const double deviation = unseen ? HUGE_VAL : std::sqrt(std::max(0.0, covariance_.matrix(column, column)));
    setInterval(parameter, unknown, coefficient, deviation, covariance_.quantile);
    result.parameters.push_back(parameter);
  }

  // Weights of a direction by name, the largest 1; the offset is no parameter.
  UndeterminedDirection direction(const Eigen::VectorXd& vector, double deviation) const {
    const Eigen::Index count = vector.size() - 1;
    Eigen::Index largest = 0;
    vector.head(count).cwiseAbs().maxCoeff(&largest);
    UndeterminedDirection result;
    result.deviation = deviation;
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
    const Eigen::Index count = covariance_.matrix.rows() - 1;
    if (count == 0) {
      return;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(covariance_.matrix.topLeftCorner(count, count));
    for (Eigen::Index i = count - 1; i >= 0; --i) {
      const double deviation = std::sqrt(std::max(0.0, eigen.eigenvalues()[i]));
      if (deviation >= kUndetermined) {
        Eigen::VectorXd vector = Eigen::VectorXd::Zero(count + 1);
        vector.head(count) = eigen.eigenvectors().col(i);
        result.undetermined.push_back(direction(vector, deviation));
      }
    }
  }

  ForceModel& model_;
  const Fit& fit_;
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

double standardDeviation(const Eigen::VectorXd& values) {
  return std::sqrt((values.array() - values.mean()).square().mean());
}

// Gives friction without dead band one that keeps the noise of the displacement from being taken for reversals.
void addDeadBands(std::vector<ElementDescription>& elements, const std::vector<Measurement>& measurements,
                  std::vector<std::string>& notes) {
  const double amplitude = scalesOf(measurements).amplitude;
  double deviation = 0.0;
  for (const Measurement& measurement : measurements) {
    deviation = std::max(deviation, noiseDeviation(measurement.displacement));
  }
  for (ElementDescription& element : elements) {
    if (element.type == "friction" && element.value("dead_band") == 0.0 &&
        kDeadBandInDeviations * deviation > kSmallestDeadBand * amplitude) {
      element.values["dead_band"] = {kDeadBandInDeviations * deviation};
      notes.push_back(
          fmt::format("friction.dead_band set to {:.3g} m, {:g} standard deviations of the displacement's "
                      "noise",
                      kDeadBandInDeviations * deviation, kDeadBandInDeviations));
    }
  }
}

// Elements that the fit left without force cannot be built; the others keep their order.
void dropElementsWithoutForce(Identification& result) {
  std::vector<int> new_index(result.elements.size(), -1);
  std::vector<ElementDescription> kept;
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

void describeResiduals(Identification& result, const Fit& fit, const Eigen::VectorXd& force,
                       const Autoregression& noise) {
  const auto count = static_cast<double>(force.size());
  const double variance = fit.residual.squaredNorm() / count;
  result.residual = std::sqrt(variance);
  result.relative_residual = result.residual / standardDeviation(force);
  result.independent_samples = independentSamples(fit.residual, noise);
  if (result.relative_residual > 0.02 && result.independent_samples < count / 50.0) {
    result.notes.push_back(
        "the residuals are strongly correlated in time: the model leaves something out that is not part of the "
        "intervals; the command diagnose tells what");
  }
}

}  // namespace

Identification identify(const std::vector<ElementDescription>& elements, const std::vector<Measurement>& measurements,
                        const IdentificationOptions& options) {
  if (measurements.empty()) {
    throw std::invalid_argument("no log given");
  }
  std::vector<Eigen::Index> runs;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    checkMeasurement(measurements[i], i + 1);
    runs.push_back(static_cast<Eigen::Index>(measurements[i].stamp.size()));
  }
  Identification result;
  std::vector<ElementDescription> completed;
  for (const ElementDescription& element : elements) {
    completed.push_back(complete(element));
  }
  checkHeld(completed, options.held);
  addDeadBands(completed, measurements, result.notes);
  ForceModel model(completed, measurements, options.held);
  if (model.nonlinear().empty() && model.linear().empty()) {
    throw std::invalid_argument("no parameter is left to be found; all are held");
  }
  const Eigen::VectorXd force = stackedForce(measurements);
  const Searches searches = searchFromSeveralStarts(model, force, options);
  result.starts = searches.starts;
  result.starts_at_best = searches.at_best;
  result.force_offset = searches.best.coefficients[searches.best.coefficients.size() - 1];
  const Autoregression noise = fitAutoregression(searches.best.residual, runs);
  Covariance covariance = covarianceOf(jacobianAt(model, searches.best), runs, noise);
  allowForFewSamples(covariance, independentSamples(searches.best.residual, noise));
  Summary(model, searches.best, covariance).describe(result);
  describeResiduals(result, searches.best, force, noise);
  dropElementsWithoutForce(result);
  return result;
}

}  // namespace rubber_suspension
