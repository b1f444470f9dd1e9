// The part of a residual that is a function of the motion, and so a missing law and no noise.
#pragma once

#include <Eigen/Core>

#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/faults.h"

namespace rubber_suspension::measurement {

/// A residual [N] of a record without what is a function of displacement, in each direction apart, or of speed:
/// piecewise linear ones, by least squares over the samples that count. Nonlinear stiffness and damping, stops, and
/// most of friction are such functions. A log takes as many functions as it can tell, so that noise stays; one of a few
/// cycles none.
Eigen::VectorXd withoutFunctionsOfMotion(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask);

}  // namespace rubber_suspension::measurement
