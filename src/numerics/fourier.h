// Spectra of real samples.
#pragma once

#include <complex>
#include <memory>
#include <vector>

namespace rubber_suspension::numerics {

/// The discrete Fourier transform of real samples, fastest for powers of two. An object stores tables for each length,
/// so use one object for all pieces of the same length.
class Fourier {
 public:
  Fourier();
  Fourier(const Fourier&) = delete;
  Fourier& operator=(const Fourier&) = delete;
  ~Fourier();

  /// Returns lines k = 0 to N/2 of N samples, sum over n of x[n] exp(-2 pi i k n / N); the others are conjugates.
  std::vector<std::complex<double>> halfSpectrum(const std::vector<double>& samples);

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

/// Returns the spectrum of samples padded with zeros to a power of two of at least `shortest`. Padding preserves
/// energies and is fast for any length.
std::vector<std::complex<double>> paddedSpectrum(std::vector<double> samples, std::size_t shortest = 2);

/// Returns the `count` real samples whose lines 0 to N/2 are given.
std::vector<double> samplesOf(const std::vector<std::complex<double>>& half_spectrum, std::size_t count);

}  // namespace rubber_suspension::numerics
