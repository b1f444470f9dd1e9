// Acceleration of a record, and the filter with which a node, which cannot look ahead, comes closest to it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// Force of a mass of 1 kg that moves with the displacement [N], by central differences.
Eigen::VectorXd acceleration(const log::Record& record);

/// Bandwidth [Hz] with which an inertia that is driven by the displacement as recorded errs least; 0: none is needed.
double massBandwidth(const std::vector<log::Record>& records, double highest_frequency);

}  // namespace rubber_suspension::fit
