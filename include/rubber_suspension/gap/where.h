// The squared gap by log, frequency, amplitude and quantity. Throws nothing.
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

/// One cell of the map of the gap.
struct GapCell {
  std::string log;
  std::array<double, 2> frequency{};  ///< [Hz]
  std::array<double, 2> amplitude{};  ///< [m]
  Quantity quantity = Quantity::stiffness;
  double share = 0.0;        ///< of the squared gap, all cells adding up to 1
  double noise_ratio = 0.0;  ///< RMS in the cell over that of the noise floor in its windows and band
  double squared = 0.0;      ///< its part of the squared gap, in variances of the force
};

/// Splits the squared residual. Each log is cut into windows of at least two periods of its slowest motion and eight of
/// its mean frequency; in each window and octave the part of the residual that is coherent with the displacement is an
/// error of stiffness (in phase) or of loss (in quadrature), the incoherent part is an error of harmonics (including
/// noise). The mean over the log is an error of the mean, the deviations of the windows' means from it are drift.
/// `residual`: measured minus simulated [N], `noise`: floor of each log in units of its force's standard deviation.
/// Sorted by share, largest first.
std::vector<GapCell> gapMap(const std::vector<PreparedRecord>& records, const std::vector<Eigen::VectorXd>& residual,
                            const std::vector<double>& noise);

}  // namespace rubber_suspension::gap
