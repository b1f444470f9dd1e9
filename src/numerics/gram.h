// Products of columns of samples: few columns, many rows.
#pragma once

#include <Eigen/Core>

namespace rubber_suspension::numerics {

/// Returns the Gram matrix columns^T * columns, to the same bits on all processors.
Eigen::MatrixXd gramOf(const Eigen::Ref<const Eigen::MatrixXd>& columns);

/// Returns left^T * right, to the same bits on all processors. Both have the same number of rows.
Eigen::MatrixXd productOf(const Eigen::Ref<const Eigen::MatrixXd>& left,
                          const Eigen::Ref<const Eigen::MatrixXd>& right);

}  // namespace rubber_suspension::numerics
