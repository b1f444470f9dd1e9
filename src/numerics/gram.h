// Products of columns of samples: few columns, many rows.
#pragma once

#include <Eigen/Core>

namespace rubber_suspension::numerics {

/// Returns the Gram matrix columns^T * columns, bit by bit the same on all processors.
Eigen::MatrixXd gramOf(const Eigen::Ref<const Eigen::MatrixXd>& columns);

/// Returns left^T * right, bit by bit the same on all processors. Both factors need the same number of rows.
Eigen::MatrixXd productOf(const Eigen::Ref<const Eigen::MatrixXd>& left,
                          const Eigen::Ref<const Eigen::MatrixXd>& right);

}  // namespace rubber_suspension::numerics
