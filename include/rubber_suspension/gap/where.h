// Divides the squared gap among logs, frequencies, amplitudes and quantities. Throws nothing.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::gap {

/// The quantity of the force that is wrong in a cell.
enum class Quantity { stiffness, loss, harmonics, mean, drift };

std::string toString(Quantity quantity);

struct GapCell {
  std::string log;
  std::array<double, 2> frequency{};  ///< [Hz]
  std::array<double, 2> amplitude{};  ///< [m]
  Quantity quantity = Quantity::stiffness;
  double share = 0.0;        ///< share of the squared gap; the shares of all cells add up to 1
  double noise_ratio = 0.0;  ///< RMS in the cell divided by that of the noise floor in the same windows and band
  /// Part of the squared gap in the cell, divided by the variance of the force.
  double squared = 0.0;
};

/// Splits the squared residual [N] into cells, and returns them in descending order of their share. Each log is cut
/// into windows of at least two periods of its slowest motion and eight periods of its mean frequency. In each window
/// and octave, the part of the residual that is coherent with the displacement is an error of the stiffness (in phase)
/// or of the loss (in quadrature). The incoherent part, which includes noise, is an error of the harmonics. The mean
/// over the log is an error of the mean, and deviations of the windows from it are drift. `residual` is measured minus
/// simulated, and `noise` the noise floor of each log divided by the standard deviation of its force.
std::vector<GapCell> gapMap(const std::vector<PreparedRecord>& records, const std::vector<Eigen::VectorXd>& residual,
                            const std::vector<double>& noise);

}  // namespace rubber_suspension::gap
