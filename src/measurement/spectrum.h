// Periodogram of a signal with missing samples, in bands that are even on a log axis.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "rubber_suspension/measurement/noise_model.h"

namespace rubber_suspension::measurement {

/// Returns the spectrum of a signal less its mean, in a Hann window, padded to a power of two of at least `shortest`.
std::vector<std::complex<double>> hannSpectrum(const Eigen::VectorXd& signal, std::size_t shortest);

/// Mean of the periodogram over a band.
struct SpectrumBand {
  double frequency;  ///< centre, in cycles per sample
  double width;      ///< cycles per sample
  double density;    ///< one-sided [unit^2 per cycle per sample]
  double level;      ///< the same by the median, which single lines such as hum do not raise
  double lines;      ///< number of independent lines in it
};

/// Returns bands of a sixth of an octave, at least one line each, from two cycles in the signal to half a cycle per
/// sample. Samples that do not count are bridged by straight lines; the mean is removed and a Hann window applied.
std::vector<SpectrumBand> spectrumBands(const Eigen::VectorXd& signal, const Mask& mask);

}  // namespace rubber_suspension::measurement
