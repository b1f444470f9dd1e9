// The part of a residual that is a function of the motion, and therefore a missing law rather than noise.
#pragma once

#include <Eigen/Core>

#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/faults.h"

namespace rubber_suspension::measurement {

/// Fits piecewise linear functions of displacement, for each direction, and of speed to a residual [N] by least squares
/// over the samples that count, and returns the residual minus these functions. Nonlinear stiffness and damping, stops,
/// and most of friction are such functions. The number of functions depends on the length of the log, so that noise
/// remains. For a log of a few cycles this number is 0.
Eigen::VectorXd withoutFunctionsOfMotion(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask);

}  // namespace rubber_suspension::measurement
