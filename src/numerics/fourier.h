// Spectra of real samples.
#pragma once

#include <complex>
#include <memory>
#include <vector>

namespace rubber_suspension::numerics {

/// The discrete Fourier transform of real samples; powers of two are fastest. It stores tables for each length, so use
/// one object for pieces of the same length.
class Fourier {
 public:
  Fourier();
  Fourier(const Fourier&) = delete;
  Fourier& operator=(const Fourier&) = delete;
  ~Fourier();

  /// Returns lines 0 to N/2 of N samples, sum over n of x[n] exp(-2 pi i k n / N); the others are their conjugates.
  std::vector<std::complex<double>> halfSpectrum(const std::vector<double>& samples);

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

/// Returns the spectrum of samples padded with zeros to a power of two, `shortest` or more: this preserves energies and
/// is fast at any length.
std::vector<std::complex<double>> paddedSpectrum(std::vector<double> samples, std::size_t shortest = 2);

/// Returns the `count` real samples with these lines 0 to N/2.
std::vector<double> samplesOf(const std::vector<std::complex<double>>& half_spectrum, std::size_t count);

}  // namespace rubber_suspension::numerics
