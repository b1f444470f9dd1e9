// Coloured noise: white and 1/f noise behind a filter of the rig, its estimation, and whitening of signals.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/measurement/faults.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::measurement {

/// A stationary model of noise: the sum of white and 1/f^exponent noise, passed through a stable all-pole filter.
///
/// The 1/f part is a sum of first-order processes with time constants from one sample to the length of the log, each 4
/// times the one before (van der Ziel, Physica 16, 1950). The filter is autoregressive and estimated by Burg's method,
/// of the order with the lowest Bayesian information criterion. No function here throws.
struct NoiseModel {
  double white = 0.0;     ///< standard deviation of the white part, before the filter
  double coloured = 0.0;  ///< standard deviation of the 1/f part, before the filter; 0 without such a part
  double exponent = 0.0;  ///< exponent of the power spectrum of the 1/f part
  std::array<double, 2> exponent_95 = {0.0, 0.0};
  double evidence = 0.0;           ///< gain in log-likelihood due to the 1/f part
  std::vector<double> reflection;  ///< coefficients of the filter's lattice, all within (-1, 1)
  double filter_innovation = 1.0;  ///< variance of the filter's first stage, 1 without a filter
  double deviation = 0.0;          ///< standard deviation of all noise
  double carried = 0.0;            ///< standard deviation of the 1/f part within an excluded band
  Eigen::Index samples = 0;        ///< length of the signal

  bool isColoured() const { return coloured > 0.0; }
};

/// Band of the spectrum, in cycles per sample, that an estimate ignores. It is the band of the motion, so that an error
/// of the model is not mistaken for noise. The default excludes nothing.
struct ExcludedBand {
  double low = 1.0;
  double high = 0.0;

  bool contains(double frequency) const { return frequency >= low && frequency <= high; }
};

/// Estimates variances and exponent by Whittle's likelihood and the filter by Burg's method. If a band is excluded,
/// there is no filter, and `deviation` combines the signal outside of the band, without single lines such as hum, with
/// the white and 1/f parts inside it. A signal with fewer than 32 samples that count is treated as white.
NoiseModel estimateNoise(const Eigen::VectorXd& signal, const Mask& mask, const ExcludedBand& excluded = {});

/// Returns true if one law (white + 1/f) fits the spectrum inside and outside of a band, so that the signal inside may
/// also be noise. The law has to fit the outside no worse than a law of its own, and to leave no peaks inside.
bool continuesInto(const ExcludedBand& band, const Eigen::VectorXd& signal, const Mask& mask);

/// Transforms noise of a model to white noise of standard deviation 1, and the columns of a least-squares system alike.
/// The filter restarts after samples that do not count.
class Whitener {
 public:
  Whitener(const NoiseModel& model, const Mask& mask);

  /// Returns the whitened columns; rows of samples that do not count are 0.
  Eigen::MatrixXd operator()(const Eigen::MatrixXd& columns) const;

 private:
  void prepareGains(const NoiseModel& model);
  void prepareFilter(const NoiseModel& model);
  Eigen::VectorXd withoutSlowParts(const Eigen::VectorXd& column) const;
  void filter(Eigen::VectorXd& column) const;

  Mask mask_;
  Eigen::ArrayXd poles_;            // poles of the first-order processes, per sample
  Eigen::ArrayXXd gains_;           // gain of each process (row) at each distinct step (column)
  std::vector<int> gain_of_;        // column of gains_ for each sample
  Eigen::ArrayXd deviation_;        // standard deviation of the innovation at each gain
  std::vector<double> reflection_;  // reflection coefficients of the filter
  std::vector<double> stage_;       // standard deviation after each stage of the filter
};

/// Returns the finding coloured_noise (exponent, share of the noise's variance); nullopt if not significant.
std::optional<RigFinding> colouredNoiseFinding(const std::string& log, const NoiseModel& model);

/// Returns the one-sided power spectral density [unit^2 per cycle per sample] of the model's white and 1/f parts.
double spectralDensity(const NoiseModel& model, double cycles_per_sample);

}  // namespace rubber_suspension::measurement
