// Periodogram in bands of equal width on a log axis.
#include "measurement/spectrum.h"

#include <cmath>

#include "measurement/statistics.h"
#include "numerics/fourier.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::measurement {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Returns |FFT|^2 of the windowed signal, padded to a power of two, as a one-sided density.
VectorXd periodogram(const VectorXd& signal) {
  constexpr std::size_t kShortest = 64;
  const double power = 0.375 * static_cast<double>(signal.size());  // power of a Hann window
  const std::vector<std::complex<double>> spectrum = hannSpectrum(signal, kShortest);
  VectorXd density(static_cast<Index>(spectrum.size()));
  for (Index i = 0; i < density.size(); ++i) {
    density[i] = 2.0 * std::norm(spectrum[static_cast<std::size_t>(i)]) / power;
  }
  return density;
}

// Returns the mean of exponentially distributed lines, from their median, which a few high lines do not raise.
double levelOf(const Eigen::Ref<const VectorXd>& lines) {
  constexpr Index kEnough = 8;
  const double mean = lines.mean();
  return lines.size() < kEnough
             ? mean
             : medianOf(std::vector<double>(lines.data(), lines.data() + lines.size())) / std::log(2.0);
}

}  // namespace

std::vector<std::complex<double>> hannSpectrum(const VectorXd& signal, std::size_t shortest) {
  const auto count = static_cast<double>(signal.size());
  const Eigen::ArrayXd place = Eigen::ArrayXd::LinSpaced(signal.size(), 0.5 / count, 1.0 - 0.5 / count);
  const VectorXd windowed = (0.5 - 0.5 * (2.0 * element::kPi * place).cos()) * (signal.array() - signal.mean());
  return numerics::paddedSpectrum({windowed.begin(), windowed.end()}, shortest);
}

std::vector<SpectrumBand> spectrumBands(const VectorXd& signal, const Mask& mask) {
  constexpr double kBandRatio = 1.122462048309373;  // 2^(1/6)
  constexpr double kHannLines = 1.5;                // number of lines that a Hann window correlates
  const auto count = static_cast<double>(signal.size());
  VectorXd measured = signal;
  bridge(measured, mask);
  const VectorXd density = periodogram(measured);
  const auto padded = static_cast<double>(2 * (density.size() - 1));
  const double line = std::max(1.0, padded / count);  // lines of the padded spectrum per line of the signal
  std::vector<SpectrumBand> bands;
  auto begin = static_cast<Index>(std::ceil(2.0 * line));
  while (begin < density.size() - 1) {
    const double edge = std::max(static_cast<double>(begin) * kBandRatio, static_cast<double>(begin) + line);
    const Index end = std::min(static_cast<Index>(std::ceil(edge)), density.size() - 1);
    const auto lines = static_cast<double>(end - begin);
    bands.push_back({0.5 * static_cast<double>(begin + end - 1) / padded, lines / padded,
                     density.segment(begin, end - begin).mean(), levelOf(density.segment(begin, end - begin)),
                     std::max(1.0, lines / line / kHannLines)});
    begin = end;
  }
  return bands;
}

}  // namespace rubber_suspension::measurement
