// Noise with colour: white, 1/f, and what a filter of the rig makes of both; and the filter that undoes it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/measurement/faults.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::measurement {

/// A stationary model of noise: (white + 1/f^exponent), seen through a stable all-pole filter. Nothing here throws.
///
/// The 1/f part is a sum of first-order processes whose time constants lie a factor of 4 apart from one sample to the
/// length of the log (van der Ziel, Physica 16, 1950), so that missing samples and the first ones are treated exactly;
/// the filter is autoregressive, by Burg's method, of the order with the lowest Bayesian information criterion.
struct NoiseModel {
  double white = 0.0;     ///< standard deviation of the white part, before the filter
  double coloured = 0.0;  ///< of the 1/f part, before the filter; 0: none is seen
  double exponent = 0.0;  ///< of the 1/f part's power spectrum
  std::array<double, 2> exponent_95 = {0.0, 0.0};
  double evidence = 0.0;           ///< log-likelihood of the 1/f part against none
  std::vector<double> reflection;  ///< coefficients of the filter's lattice, all within (-1, 1)
  double filter_innovation = 1.0;  ///< variance of the filter's first stage, 1 without a filter
  double deviation = 0.0;          ///< of the noise in all
  double carried = 0.0;            ///< of that, what the 1/f part is taken to have in an excluded band
  Eigen::Index samples = 0;        ///< that it was estimated from

  bool isColoured() const { return coloured > 0.0; }
};

/// Part of a spectrum that does not count, in cycles per sample: where the motion is, so that an error of the model is
/// not taken for noise. By default all counts.
struct ExcludedBand {
  double low = 1.0;
  double high = 0.0;

  bool contains(double frequency) const { return frequency >= low && frequency <= high; }
};

/// Variances, exponent and filter of largest likelihood (Whittle's, for the spectrum; Burg's, for the filter). With a
/// band excluded, `deviation` is the sum of what was measured outside of the band, without single lines such as hum,
/// and what white and 1/f part have in it. A signal of fewer than 32 samples that count is taken as white.
NoiseModel estimateNoise(const Eigen::VectorXd& signal, const Mask& mask, const ExcludedBand& excluded = {});

/// True where one smooth law (white + 1/f) holds inside and outside of a band, so that what is inside may be noise as
/// well: it is as likely outside as the law that was fitted there alone, and has no peaks left inside.
bool continuesInto(const ExcludedBand& band, const Eigen::VectorXd& signal, const Mask& mask);

/// Turns noise of a model into white noise of standard deviation 1, and every column of a fit alike; starts again
/// behind samples that do not count. Exact for white + 1/f and for the filter alone.
class Whitener {
 public:
  Whitener(const NoiseModel& model, const Mask& mask);

  /// Whitened columns; rows that do not count are 0.
  Eigen::MatrixXd operator()(const Eigen::MatrixXd& columns) const;

 private:
  void prepareGains(const NoiseModel& model);
  void prepareFilter(const NoiseModel& model);
  Eigen::VectorXd withoutSlowParts(const Eigen::VectorXd& column) const;
  void filter(Eigen::VectorXd& column) const;

  Mask mask_;
  Eigen::ArrayXd poles_;            // of the slow parts, per sample
  Eigen::ArrayXXd gains_;           // slow part x gain that is told apart
  std::vector<int> gain_of_;        // sample -> column of gains_
  Eigen::ArrayXd deviation_;        // of the innovation at each gain
  std::vector<double> reflection_;  // of the filter
  std::vector<double> stage_;       // standard deviation behind each stage of the filter
};

/// The finding coloured_noise, where it is beyond chance: its exponent, and the share of the noise's variance.
std::optional<RigFinding> colouredNoiseFinding(const std::string& log, const NoiseModel& model);

/// One-sided power spectral density [unit^2 per cycle per sample] of the model's white and 1/f parts.
double spectralDensity(const NoiseModel& model, double cycles_per_sample);

}  // namespace rubber_suspension::measurement
