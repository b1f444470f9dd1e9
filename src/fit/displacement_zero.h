// A displacement that was recorded too high by the same amount throughout a log.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// The knowledge of it before any fit.
struct DisplacementZero {
  double deviation = 0.0;      ///< standard deviation [m]; 0: there is none
  double one_deviation = 0.0;  ///< what that counts as, in units of the standard deviation of the force
};

/// The effect of one standard deviation of the zero on the force of elements on each record [N], its mean taken out,
/// which is a zero of the force; over what it counts as.
std::vector<Eigen::VectorXd> byZero(const std::vector<element::ElementDescription>& elements,
                                    const std::vector<log::Record>& records,
                                    const std::vector<DisplacementZero>& zeros);

}  // namespace rubber_suspension::fit
