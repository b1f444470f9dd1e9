// Derivatives by difference quotients, with their steps and sides.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace rubber_suspension::numerics {

/// Step of the logarithm of a model parameter or of a number of a law: relative truncation 1e-4, rounding 1e-12.
constexpr double kLogarithmStep = 1e-4;

/// Step of the scale of an active term, relative to its typical scale. A term whose scale is 0 is stepped by all of the
/// typical scale, so that a fit sees its effect.
constexpr double kScaleStep = 0.02;

/// Step of a coordinate in the search of `estimate`, which needs a more accurate gradient: relative truncation 1e-6,
/// rounding 1e-10.
constexpr double kSearchStep = 1e-6;

/// Returns `step`, or `-step` if only that side has a value, or 0 if neither has.
double takenStep(double step, const std::function<bool(double by)>& has_value);

/// Returns (F(x + step) - F(x))/step of each vector with the step of takenStep(); 0 if that is 0. `base`: F(x).
/// `moved`: F(x + by).
std::vector<Eigen::VectorXd> quotient(
    const std::vector<Eigen::VectorXd>& base, double step,
    const std::function<std::optional<std::vector<Eigen::VectorXd>>(double by)>& moved);

/// Returns the Jacobian by central differences with this step of each coordinate. Throws what `values` throws.
Eigen::MatrixXd centralDifferences(const std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>& values,
                                   const Eigen::VectorXd& x, double step);

/// Returns the change per sample of a signal of two samples or more, by central differences, one-sided at the ends.
Eigen::VectorXd slopesOf(const Eigen::Ref<const Eigen::VectorXd>& signal);

}  // namespace rubber_suspension::numerics
