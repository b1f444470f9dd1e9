// Periodogram of a signal with missing samples, in bands of equal width on a log axis.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "rubber_suspension/measurement/noise_model.h"

namespace rubber_suspension::measurement {

/// Returns the spectrum of a signal less its mean, in a Hann window, padded to a power of two >= `shortest`.
std::vector<std::complex<double>> hannSpectrum(const Eigen::VectorXd& signal, std::size_t shortest);

/// Mean of the periodogram over a band.
struct SpectrumBand {
  double frequency;  ///< centre, in cycles per sample
  double width;      ///< cycles per sample
  double density;    ///< one-sided [unit^2 per cycle per sample]
  double level;      ///< density estimated from the median, which single lines such as hum do not raise
  double lines;      ///< number of independent lines in the band
};

/// Returns bands of a sixth of an octave with at least one line each, from two cycles in the signal to half a cycle per
/// sample. Samples that do not count are interpolated, the mean is removed, and a Hann window is applied.
std::vector<SpectrumBand> spectrumBands(const Eigen::VectorXd& signal, const Mask& mask);

}  // namespace rubber_suspension::measurement
