// Derivatives by differences.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace rubber_suspension::numerics {

/// The Jacobian of some values by central differences over this step of each coordinate. Throws what `values` throws.
Eigen::MatrixXd centralDifferences(const std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>& values,
                                   const Eigen::VectorXd& x, double step);

/// The change from sample to sample of a signal of two or more, by central differences, one-sided at the ends.
Eigen::VectorXd slopesOf(const Eigen::Ref<const Eigen::VectorXd>& signal);

}  // namespace rubber_suspension::numerics
