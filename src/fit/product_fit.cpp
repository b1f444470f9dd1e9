// Levenberg-Marquardt within limits.
#include "fit/product_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/symmetric.h"

namespace rubber_suspension::fit {
namespace {

constexpr double kFirstRadius = 1e4;     // the first step is damped by 1e-4 of the diagonal of J'J
constexpr double kLargestRadius = 1e16;  // no damping
constexpr double kSmallestRadius = 1e-32;
constexpr double kLeastDamped = 1e-6;       // share of the force's square below which a coordinate is damped like that
constexpr double kLeastImprovement = 1e-3;  // of what a step promised, for it to be taken

// The region in which the quadratic model of the cost is trusted.
class TrustRegion {
 public:
  double radius() const { return radius_; }

  // After a step that kept this part of what it promised.
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

// By how much the quadratic model says that the cost falls.
double promise(const ProjectedCost::Value& value, const Eigen::VectorXd& step) {
  return -step.dot(2.0 * value.gradient + value.curvature * step);
}

}  // namespace

ProductFit::ProductFit(const ForceModel& model, const std::vector<log::Log>& logs)
    : cost_(model, logs), lower_(model.nonlinear().size()), upper_(model.nonlinear().size()) {
  for (std::size_t i = 0; i < model.nonlinear().size(); ++i) {
    const Unknown& unknown = model.nonlinear()[i];
    lower_[static_cast<Eigen::Index>(i)] = unknown.toSearch(unknown.lower);
    upper_[static_cast<Eigen::Index>(i)] = unknown.toSearch(unknown.upper);
  }
}

// The least of the damped quadratic model within the limits: coordinates that a step would take beyond theirs are set
// to it, one round after the other, and the step of the others is sought again.
Eigen::VectorXd ProductFit::stepFrom(const Eigen::VectorXd& x, const ProjectedCost::Value& here, double radius) const {
  Eigen::MatrixXd damped = here.curvature;
  damped.diagonal() += here.curvature.diagonal().cwiseMax(kLeastDamped * cost_.unit()) / radius;
  Eigen::VectorXd descent = -here.gradient;
  Eigen::VectorXd step = Eigen::VectorXd::Zero(x.size());
  for (Eigen::Index round = 0; round <= x.size(); ++round) {
    step = numerics::solveSymmetric(damped, descent);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      if (x[i] + step[i] < lower_[i] || x[i] + step[i] > upper_[i]) {
        step[i] = (step[i] < 0.0 ? lower_[i] : upper_[i]) - x[i];
        descent -= damped.col(i) * step[i];
        damped.row(i).setZero();
        damped.col(i).setZero();
        damped(i, i) = 1.0;
        descent[i] = step[i];
      }
    }
  }
  return inside(x + step) - x;
}

Optimum ProductFit::search(const Eigen::VectorXd& start) {
  const double rounding = UnitColumns::rounding() * cost_.unit();
  TrustRegion region;
  Eigen::VectorXd x = inside(start);
  ProjectedCost::Value here = cost_.at(x);
  double last_promise = HUGE_VAL;
  for (int i = 0; i < SearchTolerances::kMostSteps && region.radius() > kSmallestRadius; ++i) {
    const Eigen::VectorXd step = stepFrom(x, here, region.radius());
    const double promised = promise(here, step);
    if (std::abs(promised) <= SearchTolerances::kCost * here.cost ||
        step.norm() <= SearchTolerances::kStep * x.norm()) {
      return {x + step, here.cost};
    }
    ProjectedCost::Value there = cost_.at(x + step);
    if (promised > rounding || promised < 0.0) {
      const double improvement = promised > 0.0 ? (here.cost - there.cost) / promised : 0.0;
      region.adapt(improvement);
      if (!(improvement > kLeastImprovement)) {
        continue;
      }
    } else if (promised > 0.5 * last_promise) {
      break;  // the gradient has come down to its rounding
    } else {
      last_promise = promised;  // the cost cannot tell any more, but the gradient falls
    }
    x += step;
    here = std::move(there);
  }
  return {x, here.cost};
}

ModelFit ProductFit::fitAt(const Eigen::VectorXd& search) {
  const ProjectedCost::Value value = cost_.at(search);
  return {search, value.coefficients, cost_.residual(search, value.coefficients)};
}

Eigen::MatrixXd ProductFit::jacobian(const ModelFit& fit) { return cost_.jacobian(fit.search, fit.coefficients); }

Eigen::MatrixXd ProductFit::jacobianProducts(const ModelFit& fit) {
  return cost_.jacobianProducts(fit.search, fit.coefficients);
}

}  // namespace rubber_suspension::fit
