// The rating of a simulated signal against a measured one by ISO/TS 18571.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

namespace rubber_suspension::gap {

/// Ratings from 0 to 1 [-]. The standard is meant for signals that are not periodic.
struct Iso18571 {
  double corridor = 0.0;   ///< mean over the samples: 1 within 5 % of the largest measured value, 0 beyond 50 %
  double phase = 0.0;      ///< of the shift with the largest correlation
  double magnitude = 0.0;  ///< after the shift, by dynamic time warping
  double slope = 0.0;      ///< after the shift, by smoothed central differences
  double total = 0.0;      ///< 0.4 corridor + 0.2 (phase + magnitude + slope)
  bool repeats = false;    ///< the measured signal repeats itself: the shift may lead to another cycle
  std::size_t blocks = 1;  ///< of the warping
};

/// Signals up to this length are warped as a whole, as in the standard.
constexpr Eigen::Index kWarpedWhole = 10000;

/// Rates a simulated signal. Both have even time steps and one length. Signals longer than `warped_whole` are warped in
/// equal blocks of at most 2,000 samples, since the work of warping grows with the square of the length; all other
/// ratings are of the whole signal. A simulated signal that is not finite is rated 0. Throws std::invalid_argument if
/// lengths differ, there are fewer than two samples, or the measured signal is constant or not finite.
Iso18571 rateIso18571(const Eigen::VectorXd& measured, const Eigen::VectorXd& simulated,
                      Eigen::Index warped_whole = kWarpedWhole);

/// Returns the grade of a total: excellent above 0.94, good above 0.80, fair above 0.58, else poor.
std::string iso18571Grade(double total);

}  // namespace rubber_suspension::gap
