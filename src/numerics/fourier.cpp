// Spectra by Eigen's kissfft.
#include "numerics/fourier.h"

#include <unsupported/Eigen/FFT>

namespace rubber_suspension::numerics {

struct Fourier::Tables {
  Eigen::FFT<double> transform;
};

Fourier::Fourier() : tables_(std::make_unique<Tables>()) {
  tables_->transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
}

Fourier::~Fourier() = default;

std::vector<std::complex<double>> Fourier::halfSpectrum(const std::vector<double>& samples) {
  std::vector<std::complex<double>> spectrum;
  tables_->transform.fwd(spectrum, samples);
  return spectrum;
}

std::vector<std::complex<double>> paddedSpectrum(std::vector<double> samples, std::size_t shortest) {
  std::size_t length = shortest;
  while (length < samples.size()) {
    length *= 2;
  }
  samples.resize(length, 0.0);
  return Fourier().halfSpectrum(samples);
}

std::vector<double> samplesOf(const std::vector<std::complex<double>>& half_spectrum, std::size_t count) {
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<double> samples;
  transform.inv(samples, half_spectrum, static_cast<Eigen::Index>(count));
  return samples;
}

}  // namespace rubber_suspension::numerics
