// The part of a residual that is a function of the motion, and therefore a missing law rather than noise.
#pragma once

#include <Eigen/Core>

#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/faults.h"

namespace rubber_suspension::measurement {

/// Removes from a residual [N] of a record piecewise linear functions of displacement, for each direction, and of
/// speed, by least squares over the samples that count. Nonlinear stiffness and damping, stops, and most of friction
/// are such functions. The number of functions depends on the length of the log, so that noise remains; for a few
/// cycles there are none.
Eigen::VectorXd withoutFunctionsOfMotion(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask);

}  // namespace rubber_suspension::measurement
