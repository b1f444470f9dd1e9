// Noise floor of a record, from the part of the force that the motion does not cause. No function here throws.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/faults.h"

namespace rubber_suspension::measurement {

/// Returns the standard deviation [N] of the noise in the residual of the best model on a record, without errors of the
/// rig. It is estimated from repeats of the same cycle if there are enough, or else from the spectrum outside the band
/// of the motion, or else at standstill. It is at most the RMS of the residual and at least the resolution of the
/// force. `slow_noise`: limit of the noise slower than the motion [N].
double noiseFloor(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask,
                  double slow_noise = std::numeric_limits<double>::infinity());

/// Returns the log Bayes factor between two explanations of the residual beyond white noise: stationary noise, and an
/// error of the model whose power follows the force from window to window. Returns nullopt if all of the residual is
/// white noise, and 0 if the record is too short.
std::optional<double> evidenceOfNoise(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask);

/// Returns the noise floor for the residual [N] of a model, as a gap [-], without errors of the rig and without samples
/// that do not count.
double relativeFloor(const gap::PreparedRecord& record, const Eigen::VectorXd& residual);

}  // namespace rubber_suspension::measurement
