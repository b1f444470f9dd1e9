// Coloured noise: white and 1/f noise behind a filter of the rig; estimation and whitening of it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/measurement/faults.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::measurement {

/// A stationary model of noise: (white + 1/f^exponent), passed through a stable all-pole filter. Nothing here throws.
///
/// The 1/f part is a sum of first-order processes whose time constants lie a factor of 4 apart from one sample to the
/// length of the log (van der Ziel, Physica 16, 1950), so that missing samples and the first ones are treated exactly;
/// the filter is autoregressive, by Burg's method, of the order with the lowest Bayesian information criterion.
struct NoiseModel {
  double white = 0.0;     ///< standard deviation of the white part, before the filter
  double coloured = 0.0;  ///< standard deviation of the 1/f part, before the filter; 0: there is none
  double exponent = 0.0;  ///< of the 1/f part's power spectrum
  std::array<double, 2> exponent_95 = {0.0, 0.0};
  double evidence = 0.0;           ///< gain in log-likelihood by the 1/f part
  std::vector<double> reflection;  ///< coefficients of the filter's lattice, all within (-1, 1)
  double filter_innovation = 1.0;  ///< variance of the filter's first stage, 1 without a filter
  double deviation = 0.0;          ///< standard deviation of all noise
  double carried = 0.0;            ///< part of it that the 1/f part has within an excluded band
  Eigen::Index samples = 0;        ///< length of the signal

  bool isColoured() const { return coloured > 0.0; }
};

/// Band of a spectrum that does not count, in cycles per sample: that of the motion, so that an error of the model does
/// not pass for noise. By default all counts.
struct ExcludedBand {
  double low = 1.0;
  double high = 0.0;

  bool contains(double frequency) const { return frequency >= low && frequency <= high; }
};

/// Estimates variances and exponent by Whittle's likelihood and the filter by Burg's method. With a band excluded there
/// is no filter, and `deviation` is that of the signal outside of the band, without single lines such as hum, and of
/// the white and 1/f parts in it. A signal of fewer than 32 samples that count is treated as white.
NoiseModel estimateNoise(const Eigen::VectorXd& signal, const Mask& mask, const ExcludedBand& excluded = {});

/// Returns true if one law (white + 1/f) fits the spectrum inside and outside of a band, so that the signal inside may
/// be noise, too: outside it is as likely as the law that is fitted there alone, and inside no peaks remain.
bool continuesInto(const ExcludedBand& band, const Eigen::VectorXd& signal, const Mask& mask);

/// Transforms noise of a model to white noise of standard deviation 1, and every column of a fit alike. The filter
/// restarts behind samples that do not count. Exact for white + 1/f and for the filter alone.
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
  Eigen::ArrayXd poles_;            // of the first-order processes, per sample
  Eigen::ArrayXXd gains_;           // process x distinct gain
  std::vector<int> gain_of_;        // sample -> column of gains_
  Eigen::ArrayXd deviation_;        // of the innovation at each gain
  std::vector<double> reflection_;  // of the filter
  std::vector<double> stage_;       // standard deviation behind each stage of the filter
};

/// Returns the finding coloured_noise (exponent, share of the noise's variance); nullopt if it is not significant.
std::optional<RigFinding> colouredNoiseFinding(const std::string& log, const NoiseModel& model);

/// Returns the one-sided power spectral density [unit^2 per cycle per sample] of the model's white and 1/f parts.
double spectralDensity(const NoiseModel& model, double cycles_per_sample);

}  // namespace rubber_suspension::measurement
