// Fit to a table: the settled loops of the model against the points.
#include "fit/table_fit.h"

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>

#include "fit/fit_method.h"
#include "fit/model_parameters.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::fit {
namespace {

// Of a cycle; the loops of a table are known to a percent or so, and 180 samples cost the area 2e-4 of it.
constexpr int kSamplesOfSweep = 180;
constexpr double kStepOfLogarithm = 1e-4;  // of a logarithm, for differences

std::complex<double> simulated(const component::Component& component, const TablePoint& point) {
  response::LoopOptions options;
  options.samples = kSamplesOfSweep;
  options.mean = point.mean;
  const auto loop = response::characteristicsAt(component, point.frequency, point.amplitude, options).characteristics;
  return std::polar(loop.stiffness, loop.loss_angle);
}

// Relative differences, real parts and imaginary parts by turns.
Eigen::VectorXd differences(const component::Component& component, const std::vector<TablePoint>& points) {
  Eigen::VectorXd result(2 * static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::complex<double> target = points[i].complexStiffness();
    const std::complex<double> difference = (simulated(component, points[i]) - target) / std::abs(target);
    result[2 * static_cast<Eigen::Index>(i)] = difference.real();
    result[2 * static_cast<Eigen::Index>(i) + 1] = difference.imag();
  }
  return result;
}

double misfitOf(const Eigen::VectorXd& residual) {
  return residual.norm() / std::sqrt(0.5 * static_cast<double>(residual.size()));
}

// The squares of the differences over the logarithms of the parameters that are moved.
class TableSquares final : public SumOfSquares {
 public:
  TableSquares(const io::ComponentDescription& description, const std::vector<TablePoint>& points)
      : parameters_(description, Level::elements), points_(points) {
    // The break frequencies spread the elements over the range: with them kept the stiffnesses have one best fit.
    const bool spread = description.model() == estimation::Model::multi_maxwell;
    for (Eigen::Index i = 0; i < parameters_.size(); ++i) {
      const std::string& name = parameters_.names()[static_cast<std::size_t>(i)];
      if (!spread || name.find("break_frequency") == std::string::npos) {
        free_.push_back(i);
      }
    }
  }

  Eigen::Index size() const { return static_cast<Eigen::Index>(free_.size()); }
  double bound(Eigen::Index i) const { return parameters_.bound(place(i)); }
  const std::string& name(Eigen::Index i) const { return parameters_.names()[static_cast<std::size_t>(place(i))]; }
  double given(Eigen::Index i) const { return parameters_.configured(place(i)); }
  io::ComponentDescription apply(const Eigen::VectorXd& x) const { return parameters_.apply(all(x)); }

  Limits limits() const {
    Eigen::VectorXd bounds(size());
    for (Eigen::Index i = 0; i < size(); ++i) {
      bounds[i] = bound(i);
    }
    return {-bounds, bounds};
  }

  /// Throws std::invalid_argument where there is no such component.
  Eigen::VectorXd residuals(const Eigen::VectorXd& x) const { return differences(apply(x).makeComponent(), points_); }

  Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd result(2 * static_cast<Eigen::Index>(points_.size()), size());
    for (Eigen::Index i = 0; i < size(); ++i) {
      const Eigen::VectorXd step = kStepOfLogarithm * Eigen::VectorXd::Unit(size(), i);
      result.col(i) = (residuals(x + step) - residuals(x - step)) / (2.0 * kStepOfLogarithm);
    }
    return result;
  }

  double at(const Eigen::VectorXd& x) override {
    last_ = x;
    try {
      return residuals(x).squaredNorm();
    } catch (const std::invalid_argument&) {
      return std::numeric_limits<double>::infinity();
    }
  }
  Slope slope() override {
    try {
      const Eigen::MatrixXd derivatives = jacobian(last_);
      return {derivatives.transpose() * residuals(last_), derivatives.transpose() * derivatives};
    } catch (const std::invalid_argument&) {
      return {Eigen::VectorXd::Constant(size(), std::numeric_limits<double>::quiet_NaN()), {}};
    }
  }
  double unit() const override { return 1.0; }
  double rounding() const override { return 1e-20; }

 private:
  Eigen::Index place(Eigen::Index i) const { return free_[static_cast<std::size_t>(i)]; }

  Eigen::VectorXd all(const Eigen::VectorXd& x) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(parameters_.size());
    for (Eigen::Index i = 0; i < size(); ++i) {
      result[place(i)] = x[i];
    }
    return result;
  }

  ModelParameters parameters_;
  const std::vector<TablePoint>& points_;
  std::vector<Eigen::Index> free_;
  Eigen::VectorXd last_;
};

// Standard deviations of the logarithms: sigma^2 (J'J)^-1, infinite along what no point shows.
Eigen::VectorXd deviationsOf(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual) {
  const numerics::Eigensystem system = numerics::eigensystem(jacobian.transpose() * jacobian);
  const double freedom = std::max(1.0, static_cast<double>(jacobian.rows() - jacobian.cols()));
  const double variance = residual.squaredNorm() / freedom;
  const double smallest = 1e-12 * system.values.maxCoeff();
  Eigen::VectorXd result = Eigen::VectorXd::Zero(jacobian.cols());
  for (Eigen::Index k = 0; k < jacobian.cols(); ++k) {
    const double value = system.values[k];
    for (Eigen::Index i = 0; i < result.size(); ++i) {
      const double share = system.vectors(i, k) * system.vectors(i, k);
      result[i] += value > smallest ? share * variance / value
                   : share > 1e-6   ? std::numeric_limits<double>::infinity()
                                    : 0.0;
    }
  }
  return result.cwiseSqrt();
}

}  // namespace

TableFit fitToTable(const io::ComponentDescription& description, const std::vector<TablePoint>& points) {
  checkPoints(points);
  TableSquares squares(description, points);
  if (squares.size() == 0) {
    throw std::invalid_argument(description.name + ": has no parameter that a fit moves");
  }
  const Eigen::VectorXd x =
      searchLeast(squares, Eigen::VectorXd::Zero(squares.size()), squares.limits(), {200, 1e-12}).search;
  const Eigen::VectorXd residual = squares.residuals(x);
  const Eigen::VectorXd deviations = deviationsOf(squares.jacobian(x), residual);
  TableFit fit;
  fit.component = squares.apply(x);
  fit.misfit_before = misfitOf(squares.residuals(0.0 * x));
  fit.misfit = misfitOf(residual);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const bool at_bound = squares.bound(i) - std::abs(x[i]) < 1e-6;
    fit.parameters.push_back({squares.name(i), squares.given(i), squares.given(i) * std::exp(x[i]),
                              !at_bound && deviations[i] < kUndetermined, deviations[i]});
  }
  return fit;
}

}  // namespace rubber_suspension::fit
