// Prepares logs for diagnosis.
#include "rubber_suspension/log/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <complex>
#include <random>
#include <utility>

#include "element/refuse.h"
#include "log/even_blocks.h"
#include "numerics/fourier.h"
#include "numerics/median.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::log {
namespace {

// Returns the ratio of median to mean for the lines of a periodogram, which are exponentially distributed. It is ln 2
// for one segment and about 1 - 1/(3 segments) for the average over several segments.
double medianToMean(Eigen::Index segments) {
  return segments == 1 ? std::log(2.0) : 1.0 - 1.0 / (3.0 * static_cast<double>(segments));
}

Eigen::Index segmentLength(Eigen::Index samples) {
  Eigen::Index length = 64;
  while (length * 8 <= samples && length < 4096) {
    length *= 2;
  }
  return std::min(length, samples);
}

double deviation(const Eigen::VectorXd& values) { return std::sqrt((values.array() - values.mean()).square().mean()); }

// Resamples a log to even time steps, unless its steps are even.
void setTimeBase(const Log& log, Record& record) {
  TimeSteps steps;
  steps.add(log);
  const EvenSteps even = steps.evenSteps();
  element::refuseIf<LogError>(even.gaps > 0, "{}: has {} time gaps; accepted: a log without time gaps", log.name,
                              even.gaps);
  if (!even.as_recorded) {
    record.notes.push_back(
        fmt::format("uneven time base (median step {:.4g} s, worst {:.4g} s): resampled", even.median, even.worst));
  }
  record.dt = even.dt;
  const auto samples = static_cast<Eigen::Index>(even.samples);
  record.raw_displacement.resize(samples);
  record.force.resize(samples);
  record.temperature.resize(log.temperature.empty() ? 0 : samples);
  record.across.resize(log.across.empty() ? 0 : samples);
  Eigen::Index done = 0;
  const auto append = [&](const EvenBlocks::Piece& piece) {
    const auto count = static_cast<Eigen::Index>(piece.samples);
    record.raw_displacement.segment(done, count) = Eigen::Map<const Eigen::VectorXd>(piece.displacement, count);
    record.force.segment(done, count) = Eigen::Map<const Eigen::VectorXd>(piece.force, count);
    if (piece.counts != nullptr) {
      record.counts = record.counts.size() == 0 ? Eigen::VectorXd::Ones(samples) : record.counts;
      record.counts.segment(done, count) = Eigen::Map<const Eigen::VectorXd>(piece.counts, count);
    }
    for (const auto& [from, to] :
         {std::pair(piece.temperature, &record.temperature), std::pair(piece.across, &record.across)}) {
      if (from != nullptr) {
        to->segment(done, count) = Eigen::Map<const Eigen::VectorXd>(from, count);
      }
    }
    done += count;
  };
  EvenBlocks blocks(even);
  blocks.add(log, append);
  blocks.finish(append);
}

// The low-pass filter has zero phase, passes up to `frequency` and stops from kStop times `frequency` on. It is a sinc
// in a Kaiser window (Kaiser and Schafer, IEEE Trans. ASSP 28, 1980).
constexpr double kStop = 1.6;

Eigen::VectorXd lowPass(double dt, double frequency) {
  constexpr double kAttenuation = 90.0;  // [dB]; the relative error in the pass band is then 3e-5
  constexpr double kShape = 0.1102 * (kAttenuation - 8.7);
  const double width = (kStop - 1.0) * frequency * dt;
  const double middle = 0.5 * (kStop + 1.0) * frequency * dt;
  const auto half = static_cast<Eigen::Index>(std::ceil(0.5 * (kAttenuation - 7.95) / (14.36 * width)));
  Eigen::VectorXd weights(2 * half + 1);
  for (Eigen::Index k = -half; k <= half; ++k) {
    const double place = static_cast<double>(k) / static_cast<double>(half);
    const double angle = 2.0 * element::kPi * middle * static_cast<double>(k);
    const double sinc = k == 0 ? 1.0 : std::sin(angle) / angle;
    weights[k + half] = sinc * boost::math::cyl_bessel_i(0, kShape * std::sqrt(1.0 - place * place));
  }
  return weights / weights.sum();
}

// Applies the low-pass filter. Beyond the ends, the values are mirrored about the first and the last value.
Eigen::VectorXd smooth(const Eigen::VectorXd& values, double dt, double frequency) {
  const Eigen::VectorXd weights = lowPass(dt, frequency);
  const Eigen::Index half = weights.size() / 2;
  const Eigen::Index count = values.size();
  const auto at = [&](Eigen::Index i) {
    if (i < 0) {
      return 2.0 * values[0] - values[std::min(-i, count - 1)];
    }
    if (i >= count) {
      return 2.0 * values[count - 1] - values[std::max<Eigen::Index>(2 * (count - 1) - i, 0)];
    }
    return values[i];
  };
  Eigen::VectorXd result(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    if (i >= half && i + half < count) {
      result[i] = weights.dot(values.segment(i - half, 2 * half + 1));
      continue;
    }
    double sum = 0.0;
    for (Eigen::Index k = -half; k <= half; ++k) {
      sum += weights[k + half] * at(i + k);
    }
    result[i] = sum;
  }
  return result;
}

struct Spectrum {
  Eigen::VectorXd density;
  double length;  // duration of a segment [s]

  Spectrum(const Eigen::VectorXd& values, double dt)
      : density(powerSpectralDensity(values, dt, segmentLength(values.size()))),
        length(static_cast<double>(segmentLength(values.size())) * dt) {}

  double frequency(Eigen::Index line) const { return static_cast<double>(line) / length; }
};

// Returns the frequency below which 99.99 % of the displacement's power lies, after the noise floor is subtracted.
double excitedUpTo(const Spectrum& spectrum, double dt, double floor) {
  const Eigen::VectorXd density = (spectrum.density.array() - 2.0 * floor).max(0.0);
  const double total = density.sum();
  double sum = 0.0;
  for (Eigen::Index i = 0; i < density.size(); ++i) {
    sum += density[i];
    if (sum >= 0.9999 * total) {
      return spectrum.frequency(i + 1);
    }
  }
  return 0.5 / dt;
}

// Returns the highest frequency at which the displacement exceeds its noise floor. The corners of triangles and ramps
// have little power at high frequencies, but they excite a mass.
double visibleUpTo(const Spectrum& spectrum, double floor) {
  constexpr double kStandsOut = 5.0;  // noise does not exceed this by chance in a mean over 8 segments
  Eigen::Index last = spectrum.density.size() - 1;
  while (last > 0 && spectrum.density[last] < kStandsOut * floor) {
    --last;
  }
  return spectrum.frequency(last);
}

// Returns the frequency below which 2 % of the displacement's power lies. The whole log is transformed at once, because
// its slowest motion may last as long.
double slowestMotion(const Record& record) {
  const Eigen::VectorXd centred = record.displacement.array() - record.displacement.mean();
  const auto spectrum = numerics::paddedSpectrum({centred.begin(), centred.end()});
  const std::size_t half = spectrum.size() - 1;
  double total = 0.0;
  for (std::size_t i = 1; i < half; ++i) {
    total += std::norm(spectrum[i]);
  }
  std::size_t line = 1;
  for (double sum = std::norm(spectrum[line]); line + 1 < half && sum <= 0.02 * total;
       sum += std::norm(spectrum[line])) {
    ++line;
  }
  return static_cast<double>(line) / (static_cast<double>(2 * half) * record.dt);
}

double meanFrequency(const Eigen::VectorXd& displacement, double dt) {
  const Eigen::Index steps = displacement.size() - 1;
  const double squares = (displacement.tail(steps) - displacement.head(steps)).squaredNorm();
  return std::sqrt(squares / static_cast<double>(steps)) / dt / (2.0 * element::kPi * deviation(displacement));
}

void smoothDisplacement(Record& record) {
  const double nyquist = 0.5 / record.dt;
  record.displacement_noise = whiteNoiseAbove(record.raw_displacement, record.dt, 0.6 * nyquist);
  const Spectrum spectrum(record.raw_displacement, record.dt);
  const double floor = record.displacement_noise * record.displacement_noise * 2.0 * record.dt;
  record.highest_frequency = excitedUpTo(spectrum, record.dt, floor);
  const double pass = std::max(record.highest_frequency, visibleUpTo(spectrum, floor));
  if (record.displacement_noise > 1e-5 * deviation(record.raw_displacement) && kStop * pass < 0.9 * nyquist) {
    record.passed_frequency = pass;
    record.displacement = smooth(record.raw_displacement, record.dt, pass);
    record.notes.push_back(fmt::format("displacement noise {:.2g} m: smoothed above {:.3g} Hz for the fits",
                                       record.displacement_noise, pass));
  }
}

// Adds a note if several samples of the force have exactly the extreme value, because the sensor may be saturated.
void noteSaturation(Record& record) {
  for (const double extreme : {record.force.maxCoeff(), record.force.minCoeff()}) {
    const auto equal = (record.force.array() == extreme).count();
    if (equal >= 5) {
      record.notes.push_back(
          fmt::format("the force stays at its extreme value {:.4g} N for {} samples: the channel is saturated, or its "
                      "resolution is coarse",
                      extreme, equal));
    }
  }
}

}  // namespace

double Record::counted(Eigen::Index first, Eigen::Index count) const {
  return counts.size() == 0 ? static_cast<double>(count) : counts.segment(first, count).sum();
}

Eigen::VectorXd withNoiseDrawn(const Record& record, unsigned draw) {
  std::mt19937_64 generator(draw);
  std::normal_distribution<double> normal(0.0, record.displacement_noise);
  Eigen::VectorXd noise(record.size());
  for (double& value : noise) {
    value = normal(generator);
  }
  return record.displacement + noise;
}

Eigen::VectorXd powerSpectralDensity(const Eigen::VectorXd& signal, double dt, Eigen::Index segment) {
  numerics::Fourier fourier;
  const Eigen::Index lines = segment / 2 + 1;
  Eigen::VectorXd density = Eigen::VectorXd::Zero(lines);
  Eigen::ArrayXd window(segment);
  for (Eigen::Index i = 0; i < segment; ++i) {
    window[i] =
        0.5 - 0.5 * std::cos(2.0 * element::kPi * (static_cast<double>(i) + 0.5) / static_cast<double>(segment));
  }
  const double scale = 2.0 * dt / window.square().sum();
  Eigen::Index segments = 0;
  std::vector<double> piece(static_cast<std::size_t>(segment));
  for (Eigen::Index start = 0; start + segment <= signal.size(); start += std::max<Eigen::Index>(segment / 2, 1)) {
    const Eigen::ArrayXd part = signal.segment(start, segment).array();
    Eigen::Map<Eigen::ArrayXd>(piece.data(), segment) = (part - part.mean()) * window;
    const std::vector<std::complex<double>> spectrum = fourier.halfSpectrum(piece);
    for (Eigen::Index i = 0; i < lines; ++i) {
      density[i] += scale * std::norm(spectrum[static_cast<std::size_t>(i)]);
    }
    ++segments;
  }
  return density / std::max<double>(1.0, static_cast<double>(segments));
}

double whiteNoiseAbove(const Eigen::VectorXd& signal, double dt, double frequency) {
  const Eigen::Index segment = segmentLength(signal.size());
  const Eigen::VectorXd density = powerSpectralDensity(signal, dt, segment);
  const auto first = static_cast<Eigen::Index>(std::ceil(frequency * dt * static_cast<double>(segment)));
  if (density.size() - 1 - first < 8) {
    return 0.0;
  }
  const std::vector<double> lines(density.data() + first, density.data() + density.size() - 1);
  const Eigen::Index segments = std::max<Eigen::Index>(1, 2 * (signal.size() / segment) - 1);
  return std::sqrt(numerics::medianOf(lines) / medianToMean(segments) * 0.5 / dt);
}

void requireForce(const Log& log) {
  if (log.force.empty()) {
    const auto hint = std::find_if(log.notes.begin(), log.notes.end(), [](const std::string& note) {
      return note.find("force=") != std::string::npos || note.find("has no number") != std::string::npos;
    });
    throw LogError(log.name + ": has no measured force; accepted: a log with a column force_<unit>" +
                   (hint == log.notes.end() ? "" : "; " + *hint));
  }
}

bool bothChange(const Record& record) {
  const auto changes = [](const Eigen::VectorXd& values) {
    return deviation(values) > 1e-12 * values.cwiseAbs().maxCoeff();
  };
  return changes(record.force) && changes(record.raw_displacement);
}

Record rawRecord(const Log& log, LeadIn lead_in) {
  requireForce(log);
  element::refuseIf<LogError>(log.size() < kFewestSamples,
                              "{}: {} samples are too few for a diagnosis; accepted: at least {}", log.name, log.size(),
                              kFewestSamples);
  Record record;
  record.name = log.name;
  record.notes = log.notes;
  record.units = log.units;
  record.lead_in = std::move(lead_in);
  setTimeBase(log, record);
  record.force_deviation = deviation(record.force);
  record.displacement = record.raw_displacement;
  element::refuseIf<LogError>(record.counts.size() > 0 && record.counted() < static_cast<double>(kFewestSamples),
                              "{}: {:.0f} samples with a measured force are too few to diagnose; accepted: at least {}",
                              log.name, record.counted(), kFewestSamples);
  return record;
}

Record evenRecord(const Log& log, LeadIn lead_in) {
  Record record = rawRecord(log, std::move(lead_in));
  if (!bothChange(record)) {
    throw LogError(log.name + ": displacement or force does not change; accepted: a log in which both change");
  }
  return record;
}

Record makeRecord(const Log& log, LeadIn lead_in) {
  Record record = evenRecord(log, std::move(lead_in));
  smoothDisplacement(record);
  record.lowest_frequency = slowestMotion(record);
  record.mean_frequency = meanFrequency(record.displacement, record.dt);
  noteSaturation(record);
  return record;
}

}  // namespace rubber_suspension::log
