// Levenberg-Marquardt search within limits.
#include "numerics/trust_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "numerics/bounded_least_squares.h"
#include "numerics/difference_quotient.h"

namespace rubber_suspension::numerics {
namespace {

constexpr double kFirstRadius = 1e4;     // damps the first step by 1e-4 of the diagonal of J'J
constexpr double kLargestRadius = 1e16;  // hardly damps any step
constexpr double kSmallestRadius = 1e-32;
constexpr double kLeastDamped = 1e-6;  // smaller elements of diag(J'J), relative to unit(), are damped like this value
constexpr double kLeastImprovement = 1e-3;  // share of the predicted reduction that an accepted step has to achieve

// The region in which the quadratic model of the sum is trusted.
class TrustRegion {
 public:
  double radius() const { return radius_; }

  // Adapts the radius to the ratio of actual to predicted reduction.
  void adapt(double improvement) {
    if (improvement > kLeastImprovement) {
      radius_ = std::min(kLargestRadius, radius_ / std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * improvement - 1.0, 3)));
      shrinking_ = 2.0;
    } else {
      radius_ /= shrinking_;
      shrinking_ *= 2.0;
    }
  }

 private:
  double radius_ = kFirstRadius;
  double shrinking_ = 2.0;
};

// Returns the step to the minimum of the damped quadratic model within the limits.
Eigen::VectorXd stepFrom(const Eigen::VectorXd& x, const SumOfSquares::Slope& here, const Limits& limits,
                         double least_damped, double radius) {
  Eigen::MatrixXd damped = here.curvature;
  damped.diagonal() += here.curvature.diagonal().cwiseMax(least_damped) / radius;
  return boundedLeastSquares(damped, -here.gradient, limits.lower - x, limits.upper - x);
}

// Returns the reduction of the sum that the quadratic model predicts.
double promise(const SumOfSquares::Slope& here, const Eigen::VectorXd& step) {
  return -step.dot(2.0 * here.gradient + here.curvature * step);
}

bool isFinite(const SumOfSquares::Slope& slope) { return slope.gradient.allFinite() && slope.curvature.allFinite(); }

}  // namespace

double DifferencedSquares::at(const Eigen::VectorXd& x) {
  last_ = x;
  try {
    return residuals_(x).squaredNorm();
  } catch (const std::invalid_argument&) {
    return std::numeric_limits<double>::infinity();
  }
}

SumOfSquares::Slope DifferencedSquares::slope() {
  try {
    const Eigen::MatrixXd derivatives = jacobian(last_);
    return {derivatives.transpose() * residuals_(last_), derivatives.transpose() * derivatives};
  } catch (const std::invalid_argument&) {
    return {Eigen::VectorXd::Constant(last_.size(), std::numeric_limits<double>::quiet_NaN()), {}};
  }
}

Eigen::MatrixXd DifferencedSquares::jacobian(const Eigen::VectorXd& x) const {
  return centralDifferences(residuals_, x, step_);
}

Optimum searchLeast(SumOfSquares& sum, const Eigen::VectorXd& start, const Limits& limits,
                    const SearchTolerances& tolerances) {
  const double rounding = sum.rounding() * sum.unit();
  TrustRegion region;
  Eigen::VectorXd x = limits.inside(start);
  double cost = sum.at(x);
  if (x.size() == 0 || !std::isfinite(cost)) {
    return {x, cost};
  }
  SumOfSquares::Slope here = sum.slope();
  double last_promise = HUGE_VAL;
  for (int i = 0; i < tolerances.most_steps && region.radius() > kSmallestRadius && isFinite(here); ++i) {
    const Eigen::VectorXd step = stepFrom(x, here, limits, kLeastDamped * sum.unit(), region.radius());
    const double promised = promise(here, step);
    if (std::abs(promised) <= tolerances.cost * cost || step.norm() <= tolerances.step * x.norm()) {
      return {x + step, cost};
    }
    const double there = sum.at(x + step);
    if (promised > rounding || promised < 0.0) {
      const double improvement = promised > 0.0 ? (cost - there) / promised : 0.0;
      region.adapt(improvement);
      if (!(improvement > kLeastImprovement)) {
        continue;
      }
    } else if (promised > 0.5 * last_promise) {
      break;  // the gradient is as small as rounding
    } else {
      last_promise = promised;  // the sum is exact to rounding, but the gradient still decreases
    }
    x += step;
    cost = there;
    here = sum.slope();
  }
  return {x, cost};
}

}  // namespace rubber_suspension::numerics
