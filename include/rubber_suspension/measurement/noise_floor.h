// Noise floor of a record, from the part of the force that the motion does not cause. Throws nothing.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/faults.h"

namespace rubber_suspension::measurement {

/// Returns the standard deviation of the noise [N] in the residual of the best model on a record, without errors of the
/// rig: from repeats of the same cycle, else from the spectrum outside the band of the motion, else at standstill. It
/// is at most the RMS of the residual and at least the resolution of the force. `slow_noise`: limit of the noise that
/// is slower than the motion [N].
double noiseFloor(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask,
                  double slow_noise = std::numeric_limits<double>::infinity());

/// Returns the logarithm of the Bayes factor of two explanations of the residual beyond white noise: stationary noise,
/// against an error of the model, whose power follows that of the force from window to window. Nothing if all is white;
/// 0 if the record is too short.
std::optional<double> evidenceOfNoise(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask);

/// Returns the noise floor for a model's residual on a record, as a gap [-], without errors of the rig and samples that
/// do not count.
double relativeFloor(const gap::PreparedRecord& record, const Eigen::VectorXd& residual);

}  // namespace rubber_suspension::measurement
