// Bounded least squares by an active-set method.
#include "numerics/bounded_least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "numerics/least_squares.h"
#include "numerics/symmetric.h"

namespace rubber_suspension::numerics {
namespace {

// Ridge relative to the unit diagonal of the scaled Gram matrix. Without a ridge, collinear columns could have large
// opposed coefficients that depend on rounding alone.
constexpr double kRidge = 1e-9;
constexpr double kGradientTolerance = 1e-11;

struct Problem {
  Eigen::MatrixXd gram;  // scaled to a unit diagonal
  bool exact;            // no ridge, so that the rank has to be determined
  Eigen::VectorXd moment;
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
};

Eigen::VectorXd solveFree(const Problem& problem, const std::vector<int>& free, const Eigen::VectorXd& x) {
  Eigen::VectorXd fixed = x;
  fixed(free).setZero();
  const Eigen::MatrixXd gram = problem.gram(free, free);
  const Eigen::VectorXd moment = (problem.moment - problem.gram * fixed)(free);
  if (problem.exact) {
    return solveLeastNorm(gram, moment);
  }
  return solveSymmetric(gram, moment);
}

// Moves x towards the solution on the free set until a bound is reached; the variable there leaves the free set.
bool moveFeasibly(const Problem& problem, std::vector<int>& free, const Eigen::VectorXd& target, Eigen::VectorXd& x) {
  double step = 1.0;
  std::size_t blocking = free.size();
  for (std::size_t a = 0; a < free.size(); ++a) {
    const int i = free[a];
    const double goal = target[static_cast<Eigen::Index>(a)];
    const double bound = goal > x[i] ? problem.upper[i] : problem.lower[i];
    const bool outside = goal > problem.upper[i] || goal < problem.lower[i];
    if (outside && std::abs(bound - x[i]) < step * std::abs(goal - x[i])) {
      step = std::abs(bound - x[i]) / std::abs(goal - x[i]);
      blocking = a;
    }
  }
  for (std::size_t a = 0; a < free.size(); ++a) {
    const int i = free[a];
    x[i] = std::clamp(x[i] + step * (target[static_cast<Eigen::Index>(a)] - x[i]), problem.lower[i], problem.upper[i]);
  }
  if (blocking == free.size()) {
    return true;
  }
  free.erase(free.begin() + static_cast<std::ptrdiff_t>(blocking));
  return false;
}

int mostViolated(const Problem& problem, const std::vector<int>& free, const Eigen::VectorXd& x) {
  const Eigen::VectorXd descent = problem.moment - problem.gram * x;
  int best = -1;
  double largest = kGradientTolerance * std::max(1e-300, problem.moment.cwiseAbs().maxCoeff());
  for (int i = 0; i < x.size(); ++i) {
    const bool can_move = descent[i] > 0.0 ? x[i] < problem.upper[i] : x[i] > problem.lower[i];
    if (can_move && std::abs(descent[i]) > largest && std::find(free.begin(), free.end(), i) == free.end()) {
      largest = std::abs(descent[i]);
      best = i;
    }
  }
  return best;
}

Eigen::VectorXd solveWithin(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment, const Eigen::VectorXd& lower,
                            const Eigen::VectorXd& upper, double ridge) {
  const Eigen::VectorXd scale =
      gram.diagonal().array().max(1e-300).sqrt().inverse().matrix();  // the coefficient of a zero column remains 0
  Problem problem{scale.asDiagonal() * gram * scale.asDiagonal(), ridge == 0.0, scale.cwiseProduct(moment),
                  lower.cwiseQuotient(scale), upper.cwiseQuotient(scale)};
  problem.gram.diagonal().array() += ridge;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(moment.size()).cwiseMax(problem.lower).cwiseMin(problem.upper);
  std::vector<int> free;
  for (int i = 0; i < x.size(); ++i) {
    if (problem.lower[i] < x[i] && x[i] < problem.upper[i]) {
      free.push_back(i);
    }
  }
  const int most = 10 * static_cast<int>(x.size()) + 10;
  for (int iteration = 0; iteration < most; ++iteration) {
    if (!free.empty() && !moveFeasibly(problem, free, solveFree(problem, free, x), x)) {
      continue;
    }
    const int entering = mostViolated(problem, free, x);
    if (entering < 0) {
      break;
    }
    free.push_back(entering);
  }
  Eigen::VectorXd result = scale.cwiseProduct(x);
  for (Eigen::Index i = 0; i < x.size(); ++i) {  // a variable at a bound equals it exactly
    result[i] = x[i] == problem.lower[i] ? lower[i] : x[i] == problem.upper[i] ? upper[i] : result[i];
  }
  return result;
}

}  // namespace

Eigen::VectorXd boundedLeastSquares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment,
                                    const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  return solveWithin(gram, moment, lower, upper, kRidge);
}

Eigen::VectorXd nonNegativeLeastSquares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment,
                                        const std::vector<bool>& signed_unknown) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Eigen::VectorXd upper = Eigen::VectorXd::Constant(moment.size(), kInfinity);
  Eigen::VectorXd lower = Eigen::VectorXd::Zero(moment.size());
  for (Eigen::Index i = 0; i < lower.size(); ++i) {
    lower[i] = signed_unknown[static_cast<std::size_t>(i)] ? -kInfinity : 0.0;
  }
  return solveWithin(gram, moment, lower, upper, 0.0);
}

}  // namespace rubber_suspension::numerics
