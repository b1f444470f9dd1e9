// Products of the columns of a matrix with each other.
#pragma once

#include <Eigen/Core>

namespace rubber_suspension::fit {

/// The Gram matrix of some columns, columns^T * columns, to the same bits on all processors.
Eigen::MatrixXd gramOf(const Eigen::Ref<const Eigen::MatrixXd>& columns);

}  // namespace rubber_suspension::fit
