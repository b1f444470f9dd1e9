// Defines displacements that drive components over prepared records.
#pragma once

#include <cstddef>
#include <vector>

#include "gap/simulate.h"

namespace rubber_suspension::gap {

/// Returns a drive with other displacements, one per record [m]. The drive keeps references to both arguments.
inline Drive drivenBy(const std::vector<Eigen::VectorXd>& displacements, const std::vector<PreparedRecord>& records) {
  return
      [&](const PreparedRecord& record) { return displacements[static_cast<std::size_t>(&record - records.data())]; };
}

}  // namespace rubber_suspension::gap
