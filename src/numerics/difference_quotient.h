// Derivatives by difference quotients, with their steps and sides.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace rubber_suspension::numerics {

/// Step of the logarithm of a model parameter or an element's parameter: relative truncation 1e-4, rounding 1e-12.
constexpr double kLogarithmStep = 1e-4;

/// Step of the scale of an active term, relative to its typical scale. If the scale is 0, the step is the typical
/// scale, so that a fit sees the effect of the term.
constexpr double kScaleStep = 0.02;

/// Step of a coordinate in the search of `estimate`, which needs a more accurate gradient: relative truncation 1e-6,
/// rounding 1e-10.
constexpr double kSearchStep = 1e-6;

/// Returns `step`, or `-step` if the function has a value only on that side, or 0 if it has none on either side.
double takenStep(double step, const std::function<bool(double by)>& has_value);

/// Returns (F(x + step) - F(x))/step for each vector F, with the step of takenStep(); 0 if that step is 0. `base`:
/// F(x). `moved`: returns F(x + by).
std::vector<Eigen::VectorXd> quotient(
    const std::vector<Eigen::VectorXd>& base, double step,
    const std::function<std::optional<std::vector<Eigen::VectorXd>>(double by)>& moved);

/// Returns the Jacobian by central differences with the same step of each coordinate. Throws what `values` throws.
Eigen::MatrixXd centralDifferences(const std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>& values,
                                   const Eigen::VectorXd& x, double step);

/// Returns the change per sample of a signal of at least two samples, by central differences (one-sided at the ends).
Eigen::VectorXd slopesOf(const Eigen::Ref<const Eigen::VectorXd>& signal);

}  // namespace rubber_suspension::numerics
