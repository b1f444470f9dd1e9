// Variable projection on columns of all samples, the search by Ceres.
#include "fit/residual_fit.h"

#include <ceres/ceres.h>

#include "fit/bounded_least_squares.h"
#include "numerics/least_squares.h"

namespace rubber_suspension::fit {
namespace {

ModelFit evaluate(ForceModel& model, const Eigen::VectorXd& force, const Eigen::VectorXd& search) {
  model.evaluate(search);
  ModelFit fit;
  fit.search = search;
  const Eigen::MatrixXd& basis = model.basis();
  fit.coefficients = nonNegativeLeastSquares(basis.transpose() * basis, basis.transpose() * (force - model.rest()),
                                             model.signedColumns());
  fit.residual = force - model.rest() - model.basis() * fit.coefficients;
  return fit;
}

// The rest of columns once the basis has taken its share, without the columns of the basis that are held at zero.
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
  return columns - basis * numerics::solveLeastNorm(gram, moment);
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
      fit_ = evaluate(model_, force_, search);
    }
    const ModelFit& fit = fit_;
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
  mutable ModelFit fit_;  // where it was evaluated last, like the model
};

}  // namespace

Optimum ResidualFit::search(const Eigen::VectorXd& start) {
  if (start.size() == 0) {
    return {start, fitAt(start).cost()};
  }
  Eigen::VectorXd x = start;
  ceres::Problem problem;
  problem.AddResidualBlock(new ProjectedResidual(model_, force_), nullptr, x.data());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Unknown& unknown = model_.nonlinear()[static_cast<std::size_t>(i)];
    problem.SetParameterLowerBound(x.data(), static_cast<int>(i), unknown.toSearch(unknown.lower));
    problem.SetParameterUpperBound(x.data(), static_cast<int>(i), unknown.toSearch(unknown.upper));
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = SearchTolerances::kMostSteps;
  options.function_tolerance = SearchTolerances::kCost;
  options.parameter_tolerance = SearchTolerances::kStep;
  options.gradient_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  options.max_num_line_search_step_size_iterations = 0;  // steps beyond a bound are cut; no search along each step
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return {x, fitAt(x).cost()};
}

ModelFit ResidualFit::fitAt(const Eigen::VectorXd& search) { return evaluate(model_, force_, search); }

Eigen::MatrixXd ResidualFit::jacobian(const ModelFit& fit) {
  const Eigen::Index nonlinear = fit.search.size();
  Eigen::MatrixXd jacobian(model_.size(), nonlinear + fit.coefficients.size());
  for (Eigen::Index i = 0; i < nonlinear; ++i) {
    jacobian.col(i) = model_.derivative(fit.search, i, fit.coefficients);
  }
  model_.evaluate(fit.search);
  for (Eigen::Index i = 0; i < fit.coefficients.size(); ++i) {
    jacobian.col(nonlinear + i) = relativeUnit(fit.coefficients[i]) * model_.basis().col(i);
  }
  return jacobian;
}

Eigen::MatrixXd ResidualFit::jacobianProducts(const ModelFit& fit) {
  const Eigen::MatrixXd derivatives = jacobian(fit);
  return derivatives.transpose() * derivatives;
}

}  // namespace rubber_suspension::fit
