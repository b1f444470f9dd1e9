// Since when a model's error is what it is.
#include "diagnosis/live/onset.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::diagnosis::live {
namespace {

constexpr std::size_t kShortest = 4;
// Least standard deviation of a stretch: RMS values of some 100 samples of noise scatter by 1/sqrt(2 n), 7 %.
constexpr double kLeastDeviation = 0.05;
// A change has to be worth 6 in the logarithm, and 3 for each factor e in the number of places that it might have: the
// best of n places exceeds 3 parameters' gain by about 3/2 log n at chance, twice that is on the safe side.
constexpr double kLeastGain = 6.0;
constexpr double kGainPerPlace = 3.0;

/// Sums of the values before each place and of their squares.
class Sums {
 public:
  explicit Sums(const std::vector<double>& values) : sum_(values.size() + 1), square_(values.size() + 1) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      sum_[i + 1] = sum_[i] + values[i];
      square_[i + 1] = square_[i] + values[i] * values[i];
    }
  }

  double mean(std::size_t first, std::size_t last) const {
    return (sum_[last] - sum_[first]) / static_cast<double>(last - first);
  }

  // Greatest logarithm of the likelihood of a stretch, but for constants.
  double likelihood(std::size_t first, std::size_t last) const {
    const double count = static_cast<double>(last - first);
    const double middle = mean(first, last);
    const double variance = (square_[last] - square_[first]) / count - middle * middle;
    return -0.5 * count * std::log(std::max(variance, kLeastDeviation * kLeastDeviation));
  }

 private:
  std::vector<double> sum_;
  std::vector<double> square_;
};

}  // namespace

std::optional<ChangePoint> mostLikelyChange(const std::vector<double>& values) {
  const std::size_t count = values.size();
  if (count < 2 * kShortest) {
    return {};
  }
  const Sums sums(values);
  const double whole = sums.likelihood(0, count);
  ChangePoint best;
  for (std::size_t place = kShortest; place + kShortest <= count; ++place) {
    const double gain = sums.likelihood(0, place) + sums.likelihood(place, count) - whole;
    if (gain > best.likelihood) {
      best = {place, gain, sums.mean(0, place), sums.mean(place, count)};
    }
  }
  if (best.likelihood < kLeastGain + kGainPerPlace * std::log(static_cast<double>(count))) {
    return {};
  }
  return best;
}

std::optional<ChangePoint> lastChange(const std::vector<double>& values) {
  std::optional<ChangePoint> last;
  std::vector<double> rest = values;
  std::size_t offset = 0;
  while (auto change = mostLikelyChange(rest)) {
    rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(change->first));
    offset += change->first;
    last = change;
    last->first = offset;
  }
  return last;
}

}  // namespace rubber_suspension::diagnosis::live
