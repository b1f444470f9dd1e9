// Energies by octave.
#include "diagnosis/hypotheses/octaves.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "numerics/fourier.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr int kLowest = -4;  // octave that begins at 1/16 Hz
constexpr int kHighest = 8;  // all above 256 Hz

std::size_t placeOf(double frequency) {
  const int octave = frequency > 0.0 ? std::ilogb(frequency) : kLowest - 1;
  return static_cast<std::size_t>(std::clamp(octave, kLowest - 1, kHighest) - kLowest + 1);
}

}  // namespace

std::vector<double> octaveShares(const Eigen::VectorXd& values, double dt) {
  const auto spectrum = numerics::paddedSpectrum({values.data(), values.data() + values.size()});
  const double line = 0.5 / dt / static_cast<double>(spectrum.size() - 1);
  std::vector<double> shares(kHighest - kLowest + 2, 0.0);
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    shares[placeOf(line * static_cast<double>(i))] += std::norm(spectrum[i]);
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  if (!(std::isfinite(sum) && sum > 0.0)) {
    return {};
  }
  for (double& share : shares) {
    share /= sum;
  }
  return shares;
}

}  // namespace rubber_suspension::diagnosis
