// Estimation of white noise, 1/f noise and a filter from a signal, and whitening.
#include "rubber_suspension/measurement/noise_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measurement/spectrum.h"
#include "measurement/statistics.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::measurement {
namespace {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;
using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kFewestSamples = 32;
constexpr double kTimeConstantRatio = 4.0;
constexpr std::size_t kHighestOrder = 20;  // order of the filter
// Power of white noise, relative to the filtered noise, that is always assumed. Otherwise errors of a simulation near
// half of the sampling rate would have a large weight, because an anti-aliasing filter passes hardly any noise there.
constexpr double kWhiteShare = 1e-3;

// One first-order process of the 1/f part.
struct SlowPart {
  double pole;      // factor per sample
  double variance;  // share of the variance of the 1/f part
};

// Returns processes with time constants from one sample to the length of the log, whose spectra add up to 1/f^exponent.
std::vector<SlowPart> slowParts(double exponent, Index samples) {
  std::vector<SlowPart> parts;
  double sum = 0.0;
  for (double time = 1.0; time <= static_cast<double>(samples); time *= kTimeConstantRatio) {
    parts.push_back({std::exp(-1.0 / time), std::pow(time, exponent - 1.0)});
    sum += parts.back().variance;
  }
  for (SlowPart& part : parts) {
    part.variance /= sum;
  }
  return parts;
}

// Returns the one-sided spectral density of a 1/f part with variance 1.
double colouredShape(const std::vector<SlowPart>& parts, double frequency) {
  const double cosine = std::cos(2.0 * element::kPi * frequency);
  double sum = 0.0;
  for (const SlowPart& part : parts) {
    const double p = part.pole;
    sum += 2.0 * part.variance * (1.0 - p * p) / (1.0 - 2.0 * p * cosine + p * p);
  }
  return sum;
}

// White and 1/f parts of maximum likelihood for one exponent.
struct SpectralFit {
  double log_likelihood = -HUGE_VAL;
  double share = 0.0;     // share of the 1/f part in the variance
  double variance = 0.0;  // variance of both parts
};

// Maximises Whittle's likelihood for a given share. The variance follows from the shape of the spectrum in closed form.
SpectralFit fitShare(const std::vector<SpectrumBand>& bands, const std::vector<double>& shape, double share) {
  SpectralFit fit;
  fit.share = share;
  double lines = 0.0;
  double logarithms = 0.0;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const double model = 2.0 * (1.0 - share) + share * shape[i];
    lines += bands[i].lines;
    logarithms += bands[i].lines * std::log(model);
    fit.variance += bands[i].lines * bands[i].density / model;
  }
  fit.variance /= lines;
  fit.log_likelihood = -logarithms - lines * std::log(fit.variance) - lines;
  return fit;
}

SpectralFit fitExponent(const std::vector<SpectrumBand>& bands, double exponent, Index samples) {
  const std::vector<SlowPart> parts = slowParts(exponent, samples);
  std::vector<double> shape(bands.size());
  std::transform(bands.begin(), bands.end(), shape.begin(),
                 [&](const SpectrumBand& band) { return colouredShape(parts, band.frequency); });
  SpectralFit best;
  for (double odds = -7.0; odds <= 12.0; odds += 0.25) {  // log odds of the share, 0.1 % to 99.999 %
    const SpectralFit fit = fitShare(bands, shape, 1.0 / (1.0 + std::exp(-odds)));
    best = fit.log_likelihood > best.log_likelihood ? fit : best;
  }
  return best;
}

// Returns the frequency from which a filter makes the spectrum fall faster than any 1/f noise without rising again; 0.5
// if there is none.
double cutOff(const std::vector<SpectrumBand>& bands) {
  constexpr std::size_t kOctave = 6;     // bands per octave
  constexpr double kSteepest = -2.6;     // only a filter makes the spectrum fall more steeply
  constexpr double kFewestLines = 10.0;  // with fewer lines the level of a band is uncertain by a third
  for (std::size_t i = 0; i + kOctave < bands.size(); ++i) {
    if (bands[i].lines < kFewestLines || bands[i].density <= 0.0) {
      continue;
    }
    const auto& end = bands[i + kOctave];
    const double slope = std::log(std::max(end.density, 1e-30 * bands[i].density) / bands[i].density) /
                         std::log(end.frequency / bands[i].frequency);
    const bool stays = std::all_of(bands.begin() + static_cast<std::ptrdiff_t>(i + kOctave), bands.end(),
                                   [&](const SpectrumBand& band) { return band.density < 0.5 * bands[i].density; });
    if (slope < kSteepest && stays) {
      return bands[i].frequency;
    }
  }
  return 0.5;
}

std::vector<SpectrumBand> countingBands(const std::vector<SpectrumBand>& all, const ExcludedBand& excluded) {
  std::vector<SpectrumBand> outside;
  std::copy_if(all.begin(), all.end(), std::back_inserter(outside),
               [&](const SpectrumBand& band) { return !excluded.contains(band.frequency); });
  // Above a quarter of a cycle per sample, aliases change the 1/f law of the processes. The lower bands suffice.
  const double cut = std::min(cutOff(outside), 0.25);
  std::vector<SpectrumBand> counting;
  std::copy_if(outside.begin(), outside.end(), std::back_inserter(counting),
               [&](const SpectrumBand& band) { return band.frequency <= cut; });
  return counting.size() >= 4 ? counting : outside;
}

// Returns the 95 % interval of the exponent, where the log-likelihood is within 1.92 of its largest value.
std::array<double, 2> profileInterval(const std::vector<double>& exponents, const std::vector<double>& profile) {
  constexpr double kDrop = 1.92;
  const double best = *std::max_element(profile.begin(), profile.end());
  std::array<double, 2> interval = {exponents.back(), exponents.front()};
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (profile[i] >= best - kDrop) {
      interval[0] = std::min(interval[0], exponents[i]);
      interval[1] = std::max(interval[1], exponents[i]);
    }
  }
  // The interval is widened by a step of the grid, to cover the error of the sum of processes at high frequencies.
  const double step = exponents[1] - exponents[0];
  return {interval[0] - step, interval[1] + step};
}

void fitSpectrum(const std::vector<SpectrumBand>& bands, NoiseModel& model) {
  const SpectralFit white = fitShare(bands, std::vector<double>(bands.size(), 2.0), 0.0);
  model.white = std::sqrt(white.variance);
  std::vector<double> exponents;
  std::vector<double> profile;
  SpectralFit best;
  for (double exponent = 0.4; exponent < 2.05; exponent += 0.1) {
    const SpectralFit fit = fitExponent(bands, exponent, model.samples);
    exponents.push_back(exponent);
    profile.push_back(fit.log_likelihood);
    if (fit.log_likelihood > best.log_likelihood) {
      best = fit;
      model.exponent = exponent;
    }
  }
  model.evidence = best.log_likelihood - white.log_likelihood;
  double lines = 0.0;
  for (const SpectrumBand& band : bands) {
    lines += band.lines;
  }
  // The 1/f part has two more parameters, which the Bayesian information criterion has to justify.
  if (model.evidence > std::log(std::max(lines, 2.0))) {
    model.coloured = std::sqrt(best.variance * best.share);
    model.white = std::sqrt(best.variance * (1.0 - best.share));
    model.exponent_95 = profileInterval(exponents, profile);
  } else {
    model.exponent = 0.0;
  }
}

// Returns the runs of consecutive samples that count.
std::vector<std::pair<Index, Index>> runsOf(const Mask& mask) {
  std::vector<std::pair<Index, Index>> runs;
  for (Index i = 0; i < mask.size(); ++i) {
    if (mask[i] && (i == 0 || !mask[i - 1])) {
      runs.emplace_back(i, i);
    }
    if (mask[i]) {
      runs.back().second = i + 1;
    }
  }
  return runs;
}

// Estimates reflection coefficients by Burg's method over all runs (Burg 1975; Kay, Modern Spectral Estimation, 1988,
// ch. 7), of the order with the lowest Bayesian information criterion.
void fitFilter(const VectorXd& signal, const Mask& mask, NoiseModel& model) {
  const auto runs = runsOf(mask);
  const auto count = static_cast<double>(mask.count());
  VectorXd forward = signal;
  VectorXd backward = signal;
  double variance = 0.0;
  for (const auto& [begin, end] : runs) {
    variance += signal.segment(begin, end - begin).squaredNorm() / count;
  }
  model.filter_innovation = variance;
  std::vector<double> reflection;
  std::size_t best_order = 0;
  double best = count * std::log(std::max(variance, 1e-300));
  const auto highest = std::min<std::size_t>(kHighestOrder, static_cast<std::size_t>(count / 40.0));
  for (std::size_t order = 1; order <= highest; ++order) {
    const auto lag = static_cast<Index>(order);
    double product = 0.0;
    double power = 0.0;
    for (const auto& [begin, end] : runs) {
      if (end - begin > lag) {
        const auto f = forward.segment(begin + lag, end - begin - lag);
        const auto b = backward.segment(begin + lag - 1, end - begin - lag);
        product += f.dot(b);
        power += 0.5 * (f.squaredNorm() + b.squaredNorm());
      }
    }
    if (power <= 0.0) {
      break;
    }
    const double k = -product / (power * (1.0 + kWhiteShare));
    reflection.push_back(k);
    for (const auto& [begin, end] : runs) {
      for (Index i = end - 1; i >= begin + lag; --i) {
        const double f = forward[i];
        const double b = backward[i - 1];
        forward[i] = f + k * b;
        backward[i] = b + k * f;
      }
    }
    variance *= 1.0 - k * k;
    const double criterion =
        count * std::log(std::max(variance, 1e-300)) + static_cast<double>(order) * std::log(count);
    if (criterion < best) {
      best = criterion;
      best_order = order;
    }
  }
  reflection.resize(best_order);
  model.reflection = reflection;
}

// Limits values to six robust standard deviations, because a few large values would increase every estimate.
VectorXd clamped(const VectorXd& signal, const Mask& mask) {
  const double limit = 6.0 * robustDeviation(signal, mask);
  return limit > 0.0 ? VectorXd(signal.cwiseMin(limit).cwiseMax(-limit)) : signal;
}

VectorXd centred(const VectorXd& signal, const Mask& mask) {
  const double mean =
      (signal.array() * mask.cast<double>()).sum() / std::max<double>(1.0, static_cast<double>(mask.count()));
  return signal.array() - mean;
}

double whittle(const NoiseModel& model, const std::vector<SpectrumBand>& bands) {
  double sum = 0.0;
  for (const SpectrumBand& band : bands) {
    const double expected = spectralDensity(model, band.frequency);
    sum -= band.lines * (std::log(expected) + band.density / expected);
  }
  return sum;
}

// Returns the mean misfit of a model to bands: about half for a true model, because bands scatter like chi-square.
double misfit(const NoiseModel& model, const std::vector<SpectrumBand>& bands) {
  double sum = 0.0;
  for (const SpectrumBand& band : bands) {
    const double ratio = band.density / spectralDensity(model, band.frequency);
    sum += band.lines * (ratio - 1.0 - std::log(ratio));
  }
  return bands.empty() ? 0.0 : sum / static_cast<double>(bands.size());
}

}  // namespace

bool continuesInto(const ExcludedBand& excluded, const VectorXd& signal, const Mask& mask) {
  constexpr double kDrop = 3.9;    // half of chi-square with 3 parameters at 95 %
  constexpr double kMisfit = 1.0;  // twice the misfit that chance causes
  if (mask.count() < kFewestSamples || meanSquare(signal, mask) <= 0.0) {
    return false;
  }
  const std::vector<SpectrumBand> bands = spectrumBands(clamped(centred(signal, mask), mask), mask);
  const std::vector<SpectrumBand> outside = countingBands(bands, excluded);
  std::vector<SpectrumBand> inside;
  std::copy_if(bands.begin(), bands.end(), std::back_inserter(inside),
               [&](const SpectrumBand& band) { return excluded.contains(band.frequency); });
  std::vector<SpectrumBand> both = inside;
  both.insert(both.end(), outside.begin(), outside.end());
  NoiseModel alone;
  NoiseModel joint;
  alone.samples = joint.samples = signal.size();
  fitSpectrum(outside, alone);
  fitSpectrum(both, joint);
  return whittle(alone, outside) - whittle(joint, outside) < kDrop && misfit(joint, inside) < kMisfit;
}

double spectralDensity(const NoiseModel& model, double frequency) {
  double density = 2.0 * model.white * model.white;
  if (model.isColoured()) {
    density += model.coloured * model.coloured * colouredShape(slowParts(model.exponent, model.samples), frequency);
  }
  return density;
}

NoiseModel estimateNoise(const VectorXd& signal, const Mask& mask, const ExcludedBand& excluded) {
  NoiseModel model;
  model.samples = signal.size();
  const VectorXd values = clamped(centred(signal, mask), mask);
  model.deviation = std::sqrt(meanSquare(values, mask));
  model.white = model.deviation;
  if (mask.count() < kFewestSamples || model.deviation <= 0.0) {
    return model;
  }
  std::vector<SpectrumBand> all = spectrumBands(values, mask);
  if (excluded.high > excluded.low) {  // hum and resonances outside of the motion's band are no noise
    for (SpectrumBand& band : all) {
      band.density = excluded.contains(band.frequency) ? band.density : band.level;
    }
  }
  const std::vector<SpectrumBand> bands = countingBands(all, excluded);
  if (bands.size() >= 4) {
    fitSpectrum(bands, model);
  }
  if (excluded.high > excluded.low) {
    double variance = 0.0;
    double carried = 0.0;
    for (const SpectrumBand& band : all) {
      const bool inside = excluded.contains(band.frequency);
      const double density = spectralDensity(model, band.frequency);
      variance += band.width * (inside ? density : band.density);
      carried += inside ? band.width * (density - 2.0 * model.white * model.white) : 0.0;
    }
    model.deviation = std::sqrt(variance);
    model.carried = std::sqrt(std::max(0.0, carried));
    return model;
  }
  // The signal is now nearly white, at least in the bands used; the filter models the remaining colour.
  const Whitener whitener(model, mask);
  fitFilter(whitener(values).col(0), mask, model);
  return model;
}

Whitener::Whitener(const NoiseModel& model, const Mask& mask) : mask_(mask) {
  prepareGains(model);
  prepareFilter(model);
}

// Kalman's recursion for the sum of first-order processes in white noise. Gains and innovations do not depend on the
// data, so one pass serves all columns.
void Whitener::prepareGains(const NoiseModel& model) {
  const double total = model.white * model.white + model.coloured * model.coloured;
  const double scale = total > 0.0 ? std::sqrt(total) : 1.0;
  if (!model.isColoured()) {
    deviation_ = ArrayXd::Constant(1, scale);
    return;
  }
  const std::vector<SlowPart> parts = slowParts(model.exponent, model.samples);
  const auto size = static_cast<Index>(parts.size());
  poles_.resize(size);
  ArrayXd variance(size);
  for (Index i = 0; i < size; ++i) {
    poles_[i] = parts[static_cast<std::size_t>(i)].pole;
    variance[i] = parts[static_cast<std::size_t>(i)].variance * model.coloured * model.coloured;
  }
  const double white = std::max(model.white * model.white, 1e-9 * total);
  const ArrayXXd decay = (poles_.matrix() * poles_.matrix().transpose()).array();
  const ArrayXXd drive = (variance * (1.0 - poles_.square())).matrix().asDiagonal().toDenseMatrix().array();
  ArrayXXd covariance = variance.matrix().asDiagonal().toDenseMatrix().array();
  const Index count = mask_.size();
  gains_.resize(size, count);
  deviation_.resize(count);
  gain_of_.assign(static_cast<std::size_t>(count), 0);
  Index used = 0;
  bool settled = false;
  for (Index i = 0; i < count; ++i) {
    if (!mask_[i]) {
      settled = false;
    } else if (settled) {
      gain_of_[static_cast<std::size_t>(i)] = static_cast<int>(used - 1);
      continue;
    } else {
      const ArrayXd sum = covariance.rowwise().sum();
      const double innovation = sum.sum() + white;
      gains_.col(used) = sum / innovation;
      deviation_[used] = std::sqrt(innovation);
      covariance -= (sum.matrix() * sum.matrix().transpose()).array() / innovation;
      // In a thousand samples the gain then changes by less than a millionth.
      settled = used > 0 && ((gains_.col(used) - gains_.col(used - 1)).abs() < 1e-9 * gains_.col(used).abs()).all();
      gain_of_[static_cast<std::size_t>(i)] = static_cast<int>(used);
      ++used;
    }
    covariance = covariance * decay + drive;
  }
  gains_.conservativeResize(size, used);
  deviation_.conservativeResize(used);
}

void Whitener::prepareFilter(const NoiseModel& model) {
  reflection_ = model.reflection;
  double variance = model.filter_innovation;
  stage_ = {std::sqrt(variance)};
  for (const double k : reflection_) {
    variance *= 1.0 - k * k;
    stage_.push_back(std::sqrt(variance));
  }
}

VectorXd Whitener::withoutSlowParts(const VectorXd& column) const {
  if (poles_.size() == 0) {
    return (column.array() * mask_.cast<double>() / deviation_[0]).matrix();
  }
  VectorXd result = VectorXd::Zero(column.size());
  ArrayXd state = ArrayXd::Zero(poles_.size());
  for (Index i = 0; i < column.size(); ++i) {
    if (mask_[i]) {
      const Index gain = gain_of_[static_cast<std::size_t>(i)];
      const double innovation = column[i] - state.sum();
      result[i] = innovation / deviation_[gain];
      state = poles_ * (state + gains_.col(gain) * innovation);
    } else {
      state *= poles_;
    }
  }
  return result;
}

// Applies the lattice. In each run the number of stages grows with the number of samples before, up to the order.
void Whitener::filter(VectorXd& column) const {
  const std::size_t order = reflection_.size();
  std::vector<double> backward(order + 1, 0.0);  // backward errors of the preceding sample, after each stage
  std::size_t known = 0;                         // samples of the run so far
  for (Index i = 0; i < column.size(); ++i) {
    if (!mask_[i]) {
      known = 0;
      column[i] = 0.0;
      continue;
    }
    const std::size_t stages = std::min(known, order);
    double forward = column[i];
    double carried = forward;  // backward error of this sample after the preceding stage
    for (std::size_t m = 0; m < stages; ++m) {
      const double before = backward[m];
      backward[m] = carried;
      carried = before + reflection_[m] * forward;
      forward += reflection_[m] * before;
    }
    backward[stages] = carried;
    column[i] = forward / stage_[stages];
    ++known;
  }
}

Eigen::MatrixXd Whitener::operator()(const Eigen::MatrixXd& columns) const {
  Eigen::MatrixXd result(columns.rows(), columns.cols());
  for (Index j = 0; j < columns.cols(); ++j) {
    VectorXd column = withoutSlowParts(columns.col(j));
    filter(column);
    result.col(j) = column;
  }
  return result;
}

std::optional<RigFinding> colouredNoiseFinding(const std::string& log, const NoiseModel& model) {
  // Stricter than the information criterion: one false finding in a thousand logs (chi-square with 2 parameters).
  constexpr double kEvidence = 6.9;
  if (!model.isColoured() || model.evidence < kEvidence) {
    return std::nullopt;
  }
  const double slow = model.coloured * model.coloured;
  const double share = slow / (slow + model.white * model.white);
  return RigFinding{log,
                    finding::kColouredNoise,
                    model.exponent,
                    model.exponent_95,
                    "1",
                    false,
                    false,
                    fmt::format("{1:.0f} % of the noise's variance rises towards low frequencies as 1/f^{0:.1f}; the "
                                "intervals include this; check shielding and warm-up of the amplifier",
                                model.exponent, 100.0 * share)};
}

}  // namespace rubber_suspension::measurement
