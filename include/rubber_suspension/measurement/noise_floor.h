// The gap that noise alone leaves, from what the motion does not cause. Throws nothing.
#pragma once

#include <Eigen/Core>
#include <string>

#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/faults.h"

namespace rubber_suspension::measurement {

/// Standard deviations of noise [N]; divided by record.force_deviation they are gaps.
struct NoiseFloor {
  double smoothed = 0.0;  ///< of what the best model leaves, driven by record.displacement
  double replay = 0.0;    ///< driven by record.raw_displacement: with what the displacement's noise adds
  std::string source;     ///< "repeats", "spectrum", "standstill" or "model", and "quantisation" where that decides
};

/// Standard deviation of the force's noise from repeats of the same cycle: second differences over three cycles, freed
/// of what displacement and speed differ by. Slow noise, which the differences take out, is put back by the colour of
/// the residual's spectrum. 0 where fewer than 100 samples repeat.
double noiseFromRepeats(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask);

/// The same where the displacement stands still, each stop freed of a quadratic trend. 0 where it hardly does.
double noiseFromStandstill(const log::Record& record, const Mask& mask);

/// From the spectrum of a residual outside of the motion's band, carried on into it. 0 where too
/// little of the spectrum lies outside.
double noiseFromSpectrum(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask);

/// All of these in one: repeats before spectrum and standstill; never above what a model leaves; never below what the
/// force's resolution and the length of the log allow.
///
/// `residual`: measured minus simulated force of the best model, the rig's part taken out. `replay_excess`: RMS by
/// which the model's force over the raw displacement differs from that over the smoothed one [N].
NoiseFloor noiseFloor(const log::Record& record, const Eigen::VectorXd& residual, const Mask& mask,
                      double replay_excess);

/// The floor of what a model leaves of a record, as a gap [-]; the rig's part and samples that do not count are taken
/// out first.
double relativeFloor(const log::Record& record, const Eigen::VectorXd& residual);

}  // namespace rubber_suspension::measurement
