// Noise floor from repeats, standstill, spectrum and model.
#include "rubber_suspension/measurement/noise_floor.h"

#include <algorithm>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>
#include <vector>

#include "measurement/functions_of_motion.h"
#include "measurement/spectrum.h"
#include "measurement/statistics.h"
#include "numerics/least_squares.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/measurement/noise_model.h"

namespace rubber_suspension::measurement {
namespace {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kFewestRepeats = 100;  // samples, which determine a standard deviation to 7 %
constexpr Index kShortestStop = 50;
constexpr double kHarmonics = 3.0;  // harmonics of the motion that a missing law excites

// Returns the band of the motion with the harmonics that friction and kinks excite, in cycles per sample.
ExcludedBand motionBand(const log::Record& record) {
  const std::vector<SpectrumBand> bands = spectrumBands(record.displacement, Mask::Constant(record.size(), true));
  double total = 0.0;
  for (const SpectrumBand& band : bands) {
    total += band.density * band.width;
  }
  ExcludedBand motion{0.0, 0.0};  // from 0, because slow parts of the force are creep and heat, not noise
  double sum = 0.0;
  for (const SpectrumBand& band : bands) {
    sum += band.density * band.width;
    motion.high = band.frequency;
    if (sum > 0.9999 * total) {
      break;
    }
  }
  motion.high = std::min(kHarmonics * motion.high, 0.4);
  return motion;
}

// Returns the samples at which the displacement crosses its mean upwards after it was lower by 2 % of the range.
std::vector<Index> upcrossings(const VectorXd& displacement) {
  const double mean = displacement.mean();
  const double margin = 0.02 * rangeOf(displacement);
  std::vector<Index> crossings;
  bool below = false;
  for (Index i = 0; i < displacement.size(); ++i) {
    below = below || displacement[i] < mean - margin;
    if (below && displacement[i] > mean) {
      crossings.push_back(i);
      below = false;
    }
  }
  return crossings;
}

// Second differences over three cycles of force, displacement and speed.
struct Differences {
  std::vector<double> force;
  std::vector<double> displacement;
  std::vector<double> speed;
  double lag = 0.0;  // sum of all lags [samples]
};

bool hasRepeat(const VectorXd& z, Index begin, Index lag) {
  constexpr double kSameMotion = 0.02;  // largest difference between cycles, as a share of the RMS
  if (begin + 3 * lag > z.size() || lag < 4) {
    return false;
  }
  const VectorXd first = z.segment(begin, lag);
  const double size = gap::standardDeviation(first);
  return rmsOf(z.segment(begin + lag, lag) - first) < kSameMotion * size &&
         rmsOf(z.segment(begin + 2 * lag, lag) - first) < kSameMotion * size;
}

void addCycle(const log::Record& record, const Mask& mask, Index begin, Index lag, Differences& differences) {
  const VectorXd& z = record.displacement;
  for (Index i = std::max<Index>(begin, 1); i < begin + lag && i + 2 * lag + 1 < z.size(); ++i) {
    if (mask[i] && mask[i + lag] && mask[i + 2 * lag]) {
      const auto second = [&](const VectorXd& x, Index at) { return x[at] - 2.0 * x[at + lag] + x[at + 2 * lag]; };
      differences.force.push_back(second(record.force, i));
      differences.displacement.push_back(second(z, i));
      differences.speed.push_back(second(z, i + 1) - second(z, i - 1));
      differences.lag += static_cast<double>(lag);
    }
  }
}

Differences secondDifferences(const log::Record& record, const Mask& mask) {
  Differences differences;
  const std::vector<Index> crossings = upcrossings(record.displacement);
  for (std::size_t i = 0; i + 3 < crossings.size(); i += 3) {
    const Index lag = (crossings[i + 3] - crossings[i] + 1) / 3;
    if (hasRepeat(record.displacement, crossings[i], lag)) {
      addCycle(record, mask, crossings[i], lag, differences);
    }
  }
  return differences;
}

// Returns the variance of second differences at a lag, relative to that of white noise with the same variance.
double keptShare(const NoiseModel& noise, double lag) {
  constexpr int kLines = 4000;
  double kept = 0.0;
  double all = 0.0;
  for (int i = 0; i < kLines; ++i) {  // evenly on a log axis, from one cycle in the log to half a cycle per sample
    const double lowest = 1.0 / static_cast<double>(noise.samples);
    const double frequency = lowest * std::pow(0.5 / lowest, (i + 0.5) / kLines);
    const double power = spectralDensity(noise, frequency) * frequency;
    all += power;
    kept += power * std::pow(2.0 - 2.0 * std::cos(2.0 * element::kPi * frequency * lag), 2) / 6.0;
  }
  return kept / all;
}

// Returns the variance of noise, with the slow part limited to what a rig may add.
double withSlowPart(double fast_variance, double slow_variance, double slow_noise) {
  return fast_variance + std::clamp(slow_variance, 0.0, slow_noise * slow_noise);
}

// Returns the power of single lines above the motion, such as hum, which are not noise: the excess of the mean of a
// band over its level (from the median) if the mean is far above the level.
double powerOfLines(const log::Record& record, const VectorXd& residual, const Mask& mask) {
  constexpr double kFar = 3.0;
  const double motion = motionBand(record).high / kHarmonics;
  double power = 0.0;
  for (const SpectrumBand& band : spectrumBands(residual, mask)) {
    if (band.frequency > motion && band.density > kFar * band.level) {
      power += (band.density - band.level) * band.width;
    }
  }
  return power;
}

// Removes single lines, which second differences contain unless they are harmonics of the motion.
double withoutLines(double deviation, const log::Record& record, const VectorXd& residual, const Mask& mask) {
  return std::sqrt(std::max(0.0, deviation * deviation - powerOfLines(record, residual, mask)));
}

// Returns the standard deviation for a sum of squares, corrected for the degrees of freedom of the fits.
double unbiased(double square, Index count, Index freedom) {
  return std::sqrt(square / static_cast<double>(std::max<Index>(1, count - freedom)));
}

// Estimates the noise from second differences over three repeats of a cycle, without the part that differences of
// displacement and speed explain. The differences remove slow noise, which is added again according to the spectrum of
// the residual. Returns 0 if fewer than 100 samples repeat.
double noiseFromRepeats(const log::Record& record, const VectorXd& residual, const Mask& mask, double slow_noise) {
  const Differences differences = secondDifferences(record, mask);
  const auto count = static_cast<Index>(differences.force.size());
  if (count < kFewestRepeats) {
    return 0.0;
  }
  MatrixXd columns(count, 2);
  columns.col(0) = asVector(differences.displacement);
  columns.col(1) = asVector(differences.speed);
  const VectorXd force = asVector(differences.force);
  const VectorXd left = force - columns * numerics::solveLeastSquares(columns, force);
  const double deviation = robustDeviation(left, Mask::Constant(count, true)) / std::sqrt(6.0);
  const NoiseModel noise = estimateNoise(residual, mask, motionBand(record));
  const double kept = noise.isColoured() ? keptShare(noise, differences.lag / static_cast<double>(count)) : 1.0;
  const double fast = deviation * deviation;
  return std::sqrt(withSlowPart(fast, fast / kept - fast, slow_noise));
}

// Estimates the noise at standstill, without the quadratic trend of each stop. Returns 0 if the stops are too short.
double noiseFromStandstill(const log::Record& record, const Mask& mask) {
  constexpr double kStill = 1e-6;  // share of the range; the force of such a motion is far below any noise
  const VectorXd& z = record.displacement;
  const double still = kStill * rangeOf(z) + 4.0 * record.displacement_noise;
  double square = 0.0;
  Index count = 0;
  Index freedom = 0;
  for (Index begin = 0; begin + kShortestStop <= z.size();) {
    Index end = begin;
    while (end < z.size() && mask[end] && std::abs(z[end] - z[begin]) < still) {
      ++end;
    }
    // The first third is skipped, because the force relaxes fastest there.
    const Index length = (end - begin) * 2 / 3;
    if (length >= kShortestStop) {
      MatrixXd trend(length, 3);
      trend.col(1) = VectorXd::LinSpaced(length, -1.0, 1.0);
      trend.col(0).setOnes();
      trend.col(2) = trend.col(1).cwiseAbs2();
      const VectorXd force = record.force.segment(end - length, length);
      square += (force - trend * numerics::solveIndependent(trend, force)).squaredNorm();
      count += length;
      freedom += 3;
    }
    begin = std::max(end, begin + 1);
  }
  return count >= kFewestRepeats ? unbiased(square, count, freedom) : 0.0;
}

// Estimates the noise from the spectrum of a residual outside of the motion's band, extrapolated into the band. Returns
// 0 if too little of the spectrum lies outside.
double noiseFromSpectrum(const log::Record& record, const VectorXd& residual, const Mask& mask, double slow_noise) {
  constexpr double kFewestOutside = 0.1;  // cycles per sample, of the 0.5 of the whole spectrum
  const ExcludedBand motion = motionBand(record);
  if (0.5 - motion.high < kFewestOutside) {
    return 0.0;
  }
  const double square = meanSquare(residual, mask);
  const NoiseModel model = estimateNoise(residual, mask, motion);
  const double fast = model.deviation * model.deviation - model.carried * model.carried;
  const double slow = continuesInto(motion, residual, mask) ? square - fast : model.carried * model.carried;
  return std::sqrt(withSlowPart(fast, slow, slow_noise));
}

// Returns the starts of half-overlapping windows of `length` samples, more than half of which count.
std::vector<Index> windowsOf(const Mask& mask, Index length) {
  std::vector<Index> starts;
  for (Index start = 0; start + length <= mask.size(); start += length / 2) {
    if (2 * mask.segment(start, length).count() > length) {
      starts.push_back(start);
    }
  }
  return starts;
}

// Returns the power of a signal per sample that counts, for each window (row) and octave of frequency (column).
ArrayXXd powerInWindows(const VectorXd& signal, const Mask& mask, const std::vector<Index>& starts, Index length) {
  const auto octaves = static_cast<Index>(std::log2(static_cast<double>(length))) - 1;
  ArrayXXd power(static_cast<Index>(starts.size()), octaves);
  for (Index w = 0; w < power.rows(); ++w) {
    const Index start = starts[static_cast<std::size_t>(w)];
    const VectorXd counted = signal.segment(start, length).array() * mask.segment(start, length).cast<double>();
    const auto lines = hannSpectrum(counted, static_cast<std::size_t>(length));
    const auto count = static_cast<double>(mask.segment(start, length).count());
    for (Index octave = 0; octave < power.cols(); ++octave) {
      const Index first = Index{1} << octave;
      power(w, octave) = Eigen::Map<const Eigen::ArrayXcd>(lines.data() + first, first).abs2().mean() / count;
    }
  }
  return power;
}

// Returns the largest log-likelihood of normal values with any mean and a variance from `least` to `most`.
double likelihoodOf(const ArrayXd& values, double least, double most) {
  const double square = (values - values.mean()).square().mean();
  const double variance = std::clamp(square, least, most);
  return -0.5 * static_cast<double>(values.size()) * (std::log(variance) + square / variance);
}

}  // namespace

double noiseFloor(const log::Record& record, const VectorXd& residual, const Mask& mask, double slow_noise) {
  const VectorXd rest = withoutFunctionsOfMotion(record, residual, mask);
  const double left = std::sqrt(std::min(meanSquare(residual, mask), meanSquare(rest, mask)));
  const double by_spectrum = noiseFromSpectrum(record, rest, mask, slow_noise);
  double floor = noiseFromRepeats(record, rest, mask, slow_noise);
  if (floor > by_spectrum) {
    floor = std::max(by_spectrum, withoutLines(floor, record, rest, mask));
  }
  floor = floor > 0.0 ? floor : by_spectrum > 0.0 ? by_spectrum : noiseFromStandstill(record, mask);
  floor = floor > 0.0 ? std::min(floor, left) : left;
  // The floor is at least the rounding to a step of the sensor, and the rounding of arithmetic.
  return std::max({floor, smallestStep(record.force) / std::sqrt(12.0), 1e-12 * rangeOf(record.force)});
}

std::optional<double> evidenceOfNoise(const log::Record& record, const VectorXd& residual, const Mask& mask) {
  constexpr double kFewestWindows = 12.0;
  constexpr Index kShortestWindow = 32;
  constexpr double kSeen = 2.0;     // multiple of the power of white noise
  constexpr double kEven = 0.3;     // standard deviation of the logarithm of a constant power
  constexpr double kLeast = 1e-12;  // share of the mean power; keeps logarithms finite
  Index length = 1;
  while (2.0 * kFewestWindows * static_cast<double>(length) <= static_cast<double>(mask.size())) {
    length *= 2;
  }
  if (length < kShortestWindow) {
    return 0.0;
  }
  const std::vector<Index> windows = windowsOf(mask, length);
  if (static_cast<double>(windows.size()) < kFewestWindows) {
    return 0.0;
  }
  const ArrayXXd power = powerInWindows(residual, mask, windows, length);
  const ArrayXXd of_force = powerInWindows(record.force, Mask::Constant(mask.size(), true), windows, length);
  const double white = power.rightCols(2).mean();
  std::optional<double> evidence;
  for (Index octave = 1; octave + 1 < power.cols(); ++octave) {
    const double mean = power.col(octave).mean();
    if (mean <= kSeen * white) {
      continue;
    }
    const double lines = std::exp2(static_cast<double>(octave));
    const double variance = kEven * kEven + boost::math::trigamma(0.5 * (lines + 1.0));  // Hann windows correlate lines
    const ArrayXd logarithms = power.col(octave).max(kLeast * mean).log();
    double by_motion = -HUGE_VAL;
    for (const ArrayXd& motion : {ArrayXd(of_force.col(octave)), ArrayXd(of_force.rowwise().sum())}) {
      for (const double exponent : {0.5, 1.0}) {  // 0.5 for friction, which grows less than other forces
        const ArrayXd expected = motion.pow(exponent) / motion.pow(exponent).mean() + white / mean + kLeast;
        by_motion = std::max(by_motion, likelihoodOf(logarithms - expected.log(), variance, HUGE_VAL));
      }
    }
    evidence = evidence.value_or(0.0) + likelihoodOf(logarithms, variance, variance) - by_motion;
  }
  return evidence;
}

double relativeFloor(const gap::PreparedRecord& record, const Eigen::VectorXd& residual) {
  return noiseFloor(record, record.withoutRig(residual), maskOf(record), record.rig.slow_noise) /
         record.force_deviation;
}

}  // namespace rubber_suspension::measurement
