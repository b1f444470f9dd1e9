// Derivatives by difference quotients: the one place that chooses their steps and sides.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace rubber_suspension::numerics {

/// Of the logarithm of a parameter of a model, or of a number of a law: truncation 1e-4 and rounding 1e-12, relative.
constexpr double kLogarithmStep = 1e-4;

/// Of the scale of a term at work, over its typical one. A term at nothing moves by all of the typical scale, so that
/// a fit sees what it would come to.
constexpr double kScaleStep = 0.02;

/// Of a coordinate of the search of `estimate`, whose gradient has to vanish at the optimum to more digits: truncation
/// 1e-6 and rounding 1e-10, both relative.
constexpr double kSearchStep = 1e-6;

/// The step that a quotient is over: this one, or the same to the other side, or 0 where `has_value` is true of
/// neither.
double takenStep(double step, const std::function<bool(double by)>& has_value);

/// (F(x + step) - F(x))/step by takenStep(), of each vector; 0 where that is 0: the unknown cannot move. `base`: F(x).
/// `moved`: F(x + by).
std::vector<Eigen::VectorXd> quotient(
    const std::vector<Eigen::VectorXd>& base, double step,
    const std::function<std::optional<std::vector<Eigen::VectorXd>>(double by)>& moved);

/// The Jacobian of some values by central differences over this step of each coordinate. Throws what `values` throws.
Eigen::MatrixXd centralDifferences(const std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>& values,
                                   const Eigen::VectorXd& x, double step);

/// The change from sample to sample of a signal of two or more, by central differences, one-sided at the ends.
Eigen::VectorXd slopesOf(const Eigen::Ref<const Eigen::VectorXd>& signal);

}  // namespace rubber_suspension::numerics
