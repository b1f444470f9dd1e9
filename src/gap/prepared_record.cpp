// Removes the errors of the rig from the force of a record.
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::gap {

Eigen::VectorXd PreparedRecord::withoutRig(const Eigen::VectorXd& column) const {
  Eigen::VectorXd result = counts.size() == 0 ? column : column.cwiseProduct(counts).eval();
  if (rig.columns.cols() > 0) {
    result -= rig.columns * (rig.columns.transpose() * result).eval();
  }
  return result;
}

}  // namespace rubber_suspension::gap
