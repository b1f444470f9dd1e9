// Rates corridor, phase, magnitude and slope of two signals according to ISO/TS 18571.
#include "rubber_suspension/gap/iso18571.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "element/refuse.h"
#include "numerics/difference_quotient.h"
#include "numerics/fourier.h"
#include "numerics/median.h"

namespace rubber_suspension::gap {
namespace {

using Eigen::Index;
using Signal = Eigen::Ref<const Eigen::VectorXd>;

constexpr double kLargestShift = 0.2;  // share of the length
constexpr double kWindow = 0.1;        // share of the length on each side of the diagonal
constexpr Index kBlock = 2000;         // largest number of samples in a block
constexpr double kUndefined = -std::numeric_limits<double>::infinity();

double corridorRating(const Signal& measured, const Signal& simulated) {
  const double largest = measured.cwiseAbs().maxCoeff();
  const double inner = 0.05 * largest;
  const double outer = 0.5 * largest;
  const auto rating = [&](double difference) {
    const double size = std::abs(difference);
    return size < inner ? 1.0 : size > outer ? 0.0 : std::pow((outer - size) / (outer - inner), 2);
  };
  return (simulated - measured).unaryExpr(rating).mean();
}

// Computes sums of a signal and of its squares over samples [first, first + count) as differences of cumulative sums.
class RunningSums {
 public:
  explicit RunningSums(const Eigen::VectorXd& signal) : sum_(signal.size() + 1), squares_(signal.size() + 1) {
    sum_[0] = squares_[0] = 0.0;
    for (Index i = 0; i < signal.size(); ++i) {
      sum_[i + 1] = sum_[i] + signal[i];
      squares_[i + 1] = squares_[i] + signal[i] * signal[i];
    }
  }

  double mean(Index first, Index count) const {
    return (sum_[first + count] - sum_[first]) / static_cast<double>(count);
  }
  // Returns the sum of the squared deviations from the mean.
  double squares(Index first, Index count) const {
    return squares_[first + count] - squares_[first] - static_cast<double>(count) * std::pow(mean(first, count), 2);
  }
  double all() const { return squares_[squares_.size() - 1]; }

 private:
  Eigen::VectorXd sum_;
  Eigen::VectorXd squares_;
};

// Correlation coefficients of the overlap, indexed by the shift. For `left`, the second signal is shifted to the left.
struct Correlations {
  Eigen::VectorXd left;
  Eigen::VectorXd right;
};

std::vector<double> centred(const Signal& signal) {
  const Eigen::VectorXd values = signal.array() - signal.mean();
  return {values.data(), values.data() + values.size()};
}

// Returns a power of two that is large enough for transforms without wrap-around.
std::size_t paddedLength(Index size) {
  std::size_t padded = 2;
  while (padded < static_cast<std::size_t>(size)) {
    padded *= 2;
  }
  return padded;
}

Correlations correlate(const Signal& first, const Signal& second, Index most) {
  const Index size = first.size();
  const std::vector<double> a = centred(first);
  const std::vector<double> b = centred(second);
  const std::size_t padded = paddedLength(size + most);
  std::vector<std::complex<double>> product = numerics::paddedSpectrum(b, padded);
  const std::vector<std::complex<double>> other = numerics::paddedSpectrum(a, padded);
  std::transform(product.begin(), product.end(), other.begin(), product.begin(),
                 [](const auto& x, const auto& y) { return x * std::conj(y); });
  const std::vector<double> sums = numerics::samplesOf(product, padded);
  const RunningSums of_a(Eigen::Map<const Eigen::VectorXd>(a.data(), size));
  const RunningSums of_b(Eigen::Map<const Eigen::VectorXd>(b.data(), size));
  const auto coefficient = [&](double sum, Index from_a, Index from_b, Index count) {
    constexpr double kConstant = 1e-12;  // share of the sum of all squares; smaller sums are due to rounding
    const double squares_a = of_a.squares(from_a, count);
    const double squares_b = of_b.squares(from_b, count);
    const double means = static_cast<double>(count) * of_a.mean(from_a, count) * of_b.mean(from_b, count);
    return squares_a > kConstant * of_a.all() && squares_b > kConstant * of_b.all()
               ? (sum - means) / std::sqrt(squares_a * squares_b)
               : kUndefined;
  };
  Correlations result{Eigen::VectorXd(most + 1), Eigen::VectorXd(most + 1)};
  for (Index shift = 0; shift <= most; ++shift) {
    const auto place = static_cast<std::size_t>(shift);
    result.left[shift] = coefficient(sums[place], 0, shift, size - shift);
    result.right[shift] = coefficient(sums[(padded - place) % padded], shift, 0, size - shift);
  }
  return result;
}

// Returns the shift of the simulated signal (positive to the left) with the largest correlation. If several shifts are
// equal within the rounding of transforms, returns the smallest of them, preferably to the left.
Index bestShift(const Signal& measured, const Signal& simulated) {
  constexpr double kRounding = 1e-9;
  const auto most = static_cast<Index>(std::floor(kLargestShift * static_cast<double>(measured.size())));
  const Correlations found = correlate(measured, simulated, most);
  const double enough = std::max(found.left.maxCoeff(), found.right.maxCoeff()) - kRounding;
  for (Index shift = 0; std::isfinite(enough) && shift <= most; ++shift) {
    if (found.left[shift] >= enough || found.right[shift] >= enough) {
      return found.left[shift] >= enough ? shift : -shift;
    }
  }
  return 0;
}

struct Sums {
  double difference = 0.0;
  double measured = 0.0;

  double error() const {
    return difference == 0.0 ? 0.0 : measured > 0.0 ? difference / measured : std::numeric_limits<double>::infinity();
  }
};

// Finds the cheapest path through the squared differences, by steps of one sample in either signal or in both. Cells of
// one antidiagonal, whose indices have the same sum, do not depend on each other.
class Warping {
 public:
  Warping(const Signal& measured, const Signal& simulated)
      : measured_(measured),
        simulated_(simulated),
        last_(measured.size() - 1),
        reach_(std::max<Index>(1, static_cast<Index>(std::ceil(kWindow * static_cast<double>(measured.size())))) - 1),
        steps_(static_cast<std::size_t>((2 * last_ + 1) * (reach_ + 1))) {}

  Sums sums() {
    fill();
    Sums result;
    Index i = last_;
    Index j = last_;
    while (true) {
      result.difference += std::abs(simulated_[i] - measured_[j]);
      result.measured += std::abs(measured_[j]);
      if (i == 0 && j == 0) {
        return result;
      }
      const unsigned char step = steps_[place(i + j, i)];
      i -= step == kMeasured ? 0 : 1;
      j -= step == kSimulated ? 0 : 1;
    }
  }

 private:
  enum Step : unsigned char { kSimulated, kMeasured, kBoth };

  Index firstOf(Index diagonal) const {
    return std::max((std::max<Index>(0, diagonal - reach_) + 1) / 2, diagonal - last_);
  }
  Index lastOf(Index diagonal) const { return std::min((diagonal + reach_) / 2, std::min(diagonal, last_)); }
  std::size_t place(Index diagonal, Index i) const {
    return static_cast<std::size_t>(diagonal * (reach_ + 1) + i - firstOf(diagonal));
  }

  // Fills one antidiagonal after the other. The cost of sample i is stored at i + 1, between two unreachable cells.
  void fill() {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    const Eigen::VectorXd backwards = measured_.reverse();
    const Eigen::VectorXd none = Eigen::VectorXd::Constant(last_ + 3, kNever);
    std::array<Eigen::VectorXd, 3> costs = {none, none, none};  // of the two previous antidiagonals and of this one
    costs[0][0] = 0.0;  // the first cell is reached from here by a step in both signals
    for (Index diagonal = 0; diagonal <= 2 * last_; ++diagonal) {
      const Index first = firstOf(diagonal);
      const Index count = lastOf(diagonal) - first + 1;
      costs[2][first] = kNever;
      costs[2][first + count + 1] = kNever;
      const double* measured = backwards.data() + last_ - diagonal + first;
      fill({simulated_.data() + first, measured, costs[0].data() + first, costs[1].data() + first}, count,
           costs[2].data() + first + 1, steps_.data() + diagonal * (reach_ + 1));
      std::rotate(costs.begin(), costs.begin() + 1, costs.end());
    }
  }

  // Pointers to the first cell of a diagonal: into both signals, and into the costs of the two previous diagonals.
  struct Before {
    const double* simulated;
    const double* measured;
    const double* two_before;
    const double* one_before;
  };

  static void fill(const Before& before, Index count, double* cost, unsigned char* steps) {
    for (Index k = 0; k < count; ++k) {
      const double up = before.one_before[k];
      const double left = before.one_before[k + 1];
      const double both = before.two_before[k];
      const double difference = before.simulated[k] - before.measured[k];
      const double single = up < left ? up : left;
      const double least = single < both ? single : both;
      cost[k] = difference * difference + least;
      const int in_both = both < single ? 1 : 0;
      const int in_measured = left < up ? 1 : 0;
      steps[k] = static_cast<unsigned char>(2 * in_both | (in_measured & ~in_both));
    }
  }

  const Signal& measured_;
  const Signal& simulated_;
  Index last_;
  Index reach_;
  std::vector<unsigned char> steps_;
};

Sums warp(const Signal& measured, const Signal& simulated, std::size_t blocks) {
  Sums sums;
  const auto count = static_cast<Index>(blocks);
  for (Index b = 0; b < count; ++b) {
    const Index first = measured.size() * b / count;
    const Index size = measured.size() * (b + 1) / count - first;
    const Signal of_measured = measured.segment(first, size);
    const Signal of_simulated = simulated.segment(first, size);
    const Sums block = Warping(of_measured, of_simulated).sums();
    sums.difference += block.difference;
    sums.measured += block.measured;
  }
  return sums;
}

// Returns the means of 9 neighbouring central differences. Near the ends, 7, 5, 3 and 1 differences are averaged.
Eigen::VectorXd slopes(const Signal& signal) {
  const Index size = signal.size();
  const Eigen::VectorXd difference = numerics::slopesOf(signal);
  Eigen::VectorXd mean(size);
  for (Index i = 0; i < size; ++i) {
    const Index half = std::min({Index{4}, i, size - 1 - i});
    mean[i] = difference.segment(i - half, 2 * half + 1).mean();
  }
  return mean;
}

double rating(double error, double worst) { return std::max(0.0, (worst - error) / worst); }

// Returns the largest autocorrelation of a signal at lags from a quarter to a half of its length. It is 1 for a sine.
double resemblance(const Signal& signal) {
  const Index size = signal.size();
  const std::vector<double> values = centred(signal);
  const std::size_t padded = paddedLength(size + size / 2);
  std::vector<std::complex<double>> spectrum = numerics::paddedSpectrum(values, padded);
  for (std::complex<double>& line : spectrum) {
    line = std::norm(line);
  }
  const std::vector<double> sums = numerics::samplesOf(spectrum, padded);
  double most = 0.0;
  for (Index shift = size / 4; shift <= size / 2; ++shift) {
    const double overlap = static_cast<double>(size - shift) / static_cast<double>(size);
    most = std::max(most, sums[static_cast<std::size_t>(shift)] / overlap);
  }
  return sums[0] > 0.0 ? most / sums[0] : 0.0;
}

// Returns true if a signal repeats itself as a whole or in most of its pieces, as a sequence of sines does.
bool repeatsItself(const Signal& signal) {
  constexpr double kSame = 0.9;  // autocorrelation of a sine with noise of a third of the RMS of the sine
  constexpr Index kPieces = 8;
  constexpr Index kFewest = 16;  // least number of samples in a piece
  constexpr Index kLongest = 1 << 14;
  const auto part = [&](Index first, Index size) {
    return resemblance(signal.segment(first, std::min(size, kLongest)));
  };
  if (part(0, signal.size()) > kSame) {
    return true;
  }
  std::vector<double> pieces;
  for (Index p = 0; p < kPieces && signal.size() >= kPieces * kFewest; ++p) {
    const Index first = signal.size() * p / kPieces;
    pieces.push_back(part(first, signal.size() * (p + 1) / kPieces - first));
  }
  return !pieces.empty() && numerics::medianOf(pieces) > kSame;
}

}  // namespace

Iso18571 rateIso18571(const Eigen::VectorXd& measured, const Eigen::VectorXd& simulated, Eigen::Index warped_whole) {
  element::refuseIf(measured.size() != simulated.size() || measured.size() < 2,
                    "ISO/TS 18571: there are {} measured and {} simulated values; accepted: equal numbers, at least 2",
                    measured.size(), simulated.size());
  element::refuseIf(!measured.allFinite() || measured.minCoeff() == measured.maxCoeff(),
                    "ISO/TS 18571: the measured signal is constant or not finite");
  Iso18571 result;
  const bool finite = simulated.allFinite();
  // All ratings are ratios. Scaling both signals below 1 by a power of two avoids overflow and causes no rounding.
  const double largest =
      std::max(measured.lpNorm<Eigen::Infinity>(), finite ? simulated.lpNorm<Eigen::Infinity>() : 0.0);
  const double scale = std::exp2(std::clamp(-1 - std::ilogb(largest), -1022, 1022));
  const Eigen::VectorXd scaled_test = scale * measured;
  result.repeats = repeatsItself(scaled_test);
  if (!finite) {
    return result;
  }
  const Eigen::VectorXd scaled_model = scale * simulated;
  result.corridor = corridorRating(scaled_test, scaled_model);
  const Index shift = bestShift(scaled_test, scaled_model);
  const Index size = measured.size() - std::abs(shift);
  const Signal test = scaled_test.segment(std::max<Index>(-shift, 0), size);
  const Signal model = scaled_model.segment(std::max<Index>(shift, 0), size);
  result.phase = rating(static_cast<double>(std::abs(shift)), kLargestShift * static_cast<double>(measured.size()));
  result.blocks = size <= warped_whole ? 1 : static_cast<std::size_t>((size + kBlock - 1) / kBlock);
  result.magnitude = rating(warp(test, model, result.blocks).error(), 0.5);
  const Eigen::VectorXd slope = slopes(test);
  result.slope = rating(Sums{(slopes(model) - slope).lpNorm<1>(), slope.lpNorm<1>()}.error(), 2.0);
  result.total = 0.4 * result.corridor + 0.2 * (result.phase + result.magnitude + result.slope);
  return result;
}

std::string iso18571Grade(double total) {
  return total > 0.94 ? "excellent" : total > 0.80 ? "good" : total > 0.58 ? "fair" : "poor";
}

}  // namespace rubber_suspension::gap
