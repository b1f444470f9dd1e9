// Energies by octave.
#include "diagnosis/hypotheses/octaves.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "numerics/fourier.h"

namespace rubber_suspension::diagnosis::hypotheses {

std::vector<double> octaveShares(const Eigen::VectorXd& values) {
  const auto spectrum = numerics::paddedSpectrum({values.data(), values.data() + values.size()});
  std::vector<double> shares = {std::norm(spectrum.front())};
  for (std::size_t first = 1; first < spectrum.size(); first *= 2) {
    const std::size_t end = std::min(2 * first, spectrum.size());
    shares.push_back(0.0);
    for (std::size_t line = first; line < end; ++line) {
      shares.back() += std::norm(spectrum[line]);
    }
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

}  // namespace rubber_suspension::diagnosis::hypotheses
