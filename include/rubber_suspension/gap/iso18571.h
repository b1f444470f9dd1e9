// Rates a simulated signal relative to a measured one according to ISO/TS 18571.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

namespace rubber_suspension::gap {

/// Ratings from 0 to 1 [-]. The standard is meant for signals that are not periodic.
struct Iso18571 {
  double corridor = 0.0;   ///< mean over the samples: 1 within 5 % of the largest measured value, 0 beyond 50 %
  double phase = 0.0;      ///< rating of the shift with the largest correlation
  double magnitude = 0.0;  ///< rating after the shift, by dynamic time warping
  double slope = 0.0;      ///< rating after the shift, by smoothed central differences
  double total = 0.0;      ///< 0.4 corridor + 0.2 (phase + magnitude + slope)
  bool repeats = false;    ///< true if the measured signal repeats itself, so that the shift may lead to another cycle
  std::size_t blocks = 1;  ///< number of blocks that are warped separately
};

/// Signals up to this length are warped as a whole, as in the standard.
constexpr Eigen::Index kWarpedWhole = 10000;

/// Rates a simulated signal. Both signals have the same even time steps and the same length. Signals longer than
/// `warped_whole` are warped in equal blocks of at most 2,000 samples, because the work of warping grows with the
/// square of the length; all other ratings use the whole signal. A simulated signal that is not finite is rated 0.
/// Throws std::invalid_argument if lengths differ or are less than two, or if the measured signal is constant or not
/// finite.
Iso18571 rateIso18571(const Eigen::VectorXd& measured, const Eigen::VectorXd& simulated,
                      Eigen::Index warped_whole = kWarpedWhole);

/// Returns the grade of a total: excellent above 0.94, good above 0.80, fair above 0.58, otherwise poor.
std::string iso18571Grade(double total);

}  // namespace rubber_suspension::gap
