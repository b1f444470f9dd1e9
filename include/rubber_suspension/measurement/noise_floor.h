// The noise floor of a log by what a model leaves of its force.
#pragma once

#include <Eigen/Core>

#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/noise_model.h"

namespace rubber_suspension::measurement {

/// Noise of a residual [N]; what the rig added and samples that do not count are taken out first. The spectrum between
/// the motion's lowest frequency and three times its highest does not count, so that what a model lacks is not taken
/// for noise: white and 1/f part are those outside of that band.
NoiseModel noiseOf(const log::Record& record, const Eigen::VectorXd& residual);

/// Noise floor of a record as a gap [-]: that of noiseOf(), but no more than the residual itself, nor, where the noise
/// has no colour, than the measured force has above the band (a mass that a noisy displacement drives makes more).
/// Never 0: at least what the rounding of the recorded numbers leaves.
double noiseFloor(const log::Record& record, const Eigen::VectorXd& residual);

}  // namespace rubber_suspension::measurement
