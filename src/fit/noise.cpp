// Noise of a recorded signal.
#include "fit/noise.h"

#include <algorithm>
#include <cmath>

#include "numerics/median.h"
#include "rubber_suspension/fit/identification.h"

namespace rubber_suspension::fit {
namespace {

constexpr int kHighestOrder = 10;
constexpr double kNormalMedian = 0.6745;  // median of |x| of a standard normal variable

// The differences of a signal, one order after the other.
class Differences {
 public:
  explicit Differences(const std::vector<double>& signal) : values_(signal) {}

  bool next() {
    if (order_ == kHighestOrder || values_.size() < 2) {
      return false;
    }
    ++order_;
    for (std::size_t i = 0; i + 1 < values_.size(); ++i) {
      values_[i] = values_[i + 1] - values_[i];
    }
    values_.pop_back();
    gain_ *= (4.0 * order_ - 2.0) / order_;
    return true;
  }

  // Whether noise of this standard deviation would have a median at least that of the differences.
  bool medianReachedBy(double standard_deviation) const {
    const double limit = standard_deviation * unit();
    std::size_t within = 0;
    for (const double value : values_) {
      within += std::abs(value) <= limit ? 1 : 0;
    }
    return within > values_.size() / 2;
  }

  // Of the noise whose differences have this median.
  double standardDeviation() const {
    std::vector<double> magnitude(values_.size());
    std::transform(values_.begin(), values_.end(), magnitude.begin(), [](double value) { return std::abs(value); });
    return numerics::medianOf(std::move(magnitude)) / unit();
  }

 private:
  double unit() const { return kNormalMedian * std::sqrt(gain_); }

  std::vector<double> values_;
  int order_ = 0;
  double gain_ = 1.0;  // variance of the differences of white noise: the binomial coefficient (2 k over k)
};

}  // namespace

double noiseStandardDeviation(const std::vector<double>& signal) {
  Differences differences(signal);
  double smallest = HUGE_VAL;
  while (differences.next()) {
    if (differences.medianReachedBy(smallest)) {
      smallest = differences.standardDeviation();
    }
  }
  return std::isfinite(smallest) ? smallest : 0.0;
}

bool noisierThan(const std::vector<double>& signal, double standard_deviation) {
  Differences differences(signal);
  bool noisier = signal.size() > 1;
  while (noisier && differences.next()) {
    noisier = !differences.medianReachedBy(standard_deviation);
  }
  return noisier;
}

}  // namespace rubber_suspension::fit
