// Linear least squares by an active set.
#include "fit/linear_least_squares.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <limits>

namespace rubber_suspension::fit {
namespace {

// Gradient, relative to |b|, below which an unknown at zero stays there.
constexpr double kGradientTolerance = 1e-12;

struct ScaledProblem {
  Eigen::MatrixXd gram;    // of the columns scaled to length 1
  Eigen::VectorXd moment;  // of the same columns with b
  Eigen::VectorXd length;  // of the columns
};

ScaledProblem scale(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment) {
  ScaledProblem problem;
  problem.length = gram.diagonal().cwiseSqrt();
  const Eigen::VectorXd inverse = problem.length.unaryExpr([](double x) { return x > 0.0 ? 1.0 / x : 0.0; });
  problem.gram = inverse.asDiagonal() * gram * inverse.asDiagonal();
  problem.moment = inverse.asDiagonal() * moment;
  return problem;
}

Eigen::VectorXd solvePassive(const ScaledProblem& problem, const std::vector<bool>& passive) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < problem.moment.size(); ++i) {
    if (passive[static_cast<std::size_t>(i)]) {
      rows.push_back(i);
    }
  }
  const auto size = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd gram(size, size);
  Eigen::VectorXd moment(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    moment[i] = problem.moment[rows[static_cast<std::size_t>(i)]];
    for (Eigen::Index j = 0; j < size; ++j) {
      gram(i, j) = problem.gram(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
    }
  }
  const Eigen::VectorXd part = solveLeastNorm(gram, moment);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(problem.moment.size());
  for (Eigen::Index i = 0; i < size; ++i) {
    x[rows[static_cast<std::size_t>(i)]] = part[i];
  }
  return x;
}

// Walk from x towards the target until an unknown meets zero, which then leaves the passive set.
bool walk(Eigen::VectorXd& x, const Eigen::VectorXd& target, const std::vector<bool>& signed_unknown,
          std::vector<bool>& passive) {
  double step = 1.0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (passive[at] && !signed_unknown[at] && target[i] <= 0.0) {
      step = std::min(step, x[i] > 0.0 ? x[i] / (x[i] - target[i]) : 0.0);
    }
  }
  x += step * (target - x);
  bool arrived = true;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (passive[at] && !signed_unknown[at] && target[i] <= 0.0 &&
        x[i] <= 1e-15 * (1.0 + target.cwiseAbs().maxCoeff())) {
      x[i] = 0.0;
      passive[at] = false;
      arrived = false;
    }
  }
  return arrived;
}

}  // namespace

Eigen::VectorXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

Eigen::MatrixXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

Eigen::VectorXd solveLeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                  const std::vector<bool>& signed_unknown) {
  return solveNormalEquations(a.transpose() * a, a.transpose() * b, b.norm(), signed_unknown);
}

Eigen::VectorXd solveNormalEquations(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment, double norm,
                                     const std::vector<bool>& signed_unknown) {
  const ScaledProblem problem = scale(gram, moment);
  const Eigen::Index count = gram.cols();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(count);
  std::vector<bool> passive = signed_unknown;
  const double tolerance = kGradientTolerance * norm;
  for (Eigen::Index round = 0; round <= 3 * count; ++round) {
    for (Eigen::Index inner = 0; inner <= count; ++inner) {
      if (walk(x, solvePassive(problem, passive), signed_unknown, passive)) {
        break;
      }
    }
    const Eigen::VectorXd gradient = problem.moment - problem.gram * x;
    Eigen::Index best = -1;
    for (Eigen::Index i = 0; i < count; ++i) {
      const bool candidate = !passive[static_cast<std::size_t>(i)] && problem.length[i] > 0.0;
      if (candidate && gradient[i] > tolerance && (best < 0 || gradient[i] > gradient[best])) {
        best = i;
      }
    }
    if (best < 0) {
      break;
    }
    passive[static_cast<std::size_t>(best)] = true;
  }
  return x.cwiseQuotient(problem.length.unaryExpr([](double length) { return length > 0.0 ? length : 1.0; }));
}

}  // namespace rubber_suspension::fit
