// Finds the spectral lines that mains or a pump add to the force of all logs.
#include "diagnosis/prepare/lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <complex>
#include <iterator>
#include <string>

#include "numerics/fourier.h"
#include "numerics/median.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::prepare {
namespace {

using Complex = std::complex<double>;
using Eigen::ArrayXcd;
using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double kLongestBlock = 2.0;  // longest block [s]; the phase of mains hardly drifts in this time
constexpr double kFewestBlocks = 12.0;
constexpr Index kMainLobe = 2;         // number of frequencies on each side that belong to a line in a Hann window
constexpr Index kNeighbours = 6;       // a line is compared with frequencies up to this distance on each side
constexpr double kSteady = 0.15;       // standard deviation of a steady amplitude, divided by the amplitude
constexpr double kDrift = 0.3;         // standard deviation of the phase drift from block to block [rad]
constexpr double kFewestCycles = 8.0;  // least number of cycles in a window in which the phase of a line is estimated
constexpr double kShortestWindow = 0.25;  // least length of these windows, in lengths of a block
constexpr double kLikely = 3.0;           // least log Bayes factor of a line in one log: ln 20
constexpr double kRare = 4.6;             // negative logarithm of the prior probability of a line, 1 %
constexpr double kLoud = 3.0;      // a line is visible if its amplitude is this many times that of its neighbours
constexpr int kMultiples = 60;     // highest harmonic of the motion that the force may contain
constexpr double kResolved = 2.0;  // two frequencies are resolved if they differ by this many times 1/duration

// Oscillation of steady amplitude whose phase drifts slowly.
struct Line {
  double frequency;  // [Hz]
  double amplitude;  // in the unit of the signal
  double evidence;   // logarithm of the Bayes factor of a line relative to noise of the same power
};

ArrayXd hannWindow(Index length) {
  const ArrayXd places = ArrayXd::LinSpaced(length, 0.5, static_cast<double>(length) - 0.5);
  return 0.5 - 0.5 * (places * (2.0 * element::kPi / static_cast<double>(length))).cos();
}

// Returns the logarithm of the modified Bessel function of order 0.
double logBessel(double x) {
  constexpr double kLarge = 100.0;
  return x < kLarge ? std::log(boost::math::cyl_bessel_i(0, x)) : x - 0.5 * std::log(2.0 * element::kPi * x);
}

class BlockSpectra {
 public:
  BlockSpectra(const VectorXd& signal, double step) {
    const double longest = std::min(kLongestBlock, step * static_cast<double>(signal.size()) / kFewestBlocks);
    Index length = 1;
    while (2.0 * step * static_cast<double>(length) <= longest) {
      length *= 2;
    }
    width_ = 1.0 / (step * static_cast<double>(length));
    if (length <= 2 * kNeighbours) {
      return;  // a block has too few samples for any line
    }
    ArrayXd window = hannWindow(length);
    window *= 2.0 / window.sum();
    numerics::Fourier fourier;
    spectra_.resize(signal.size() / length, length / 2 + 1);
    for (Index b = 0; b < spectra_.rows(); ++b) {
      const auto block = signal.segment(b * length, length).array();
      const ArrayXd windowed = (block - block.mean()) * window;
      const std::vector<Complex> lines = fourier.halfSpectrum({windowed.begin(), windowed.end()});
      spectra_.row(b) = Eigen::Map<const ArrayXcd>(lines.data(), spectra_.cols()).transpose();
    }
    power_ = spectra_.abs2().colwise().mean();
  }

  double width() const { return width_; }  // distance between neighbouring frequencies [Hz]
  double count() const { return static_cast<double>(power_.size()); }

  // Returns the lines that exceed the loudest of their neighbours.
  std::vector<Line> isolatedLines() const {
    return linesAbove([&](Index i) { return loudestBeside(i); });
  }

  // Returns the lines that exceed the median of their neighbours, in ascending order of frequency.
  std::vector<Line> allLines() const {
    return linesAbove([&](Index i) { return numerics::medianOf(powersBeside(i)); });
  }

  // Returns true if the amplitude at a frequency exceeds the lower quartile of its neighbours by the factor kLoud. The
  // median would be too high where a motion has several frequencies close together.
  bool standsOutAt(double frequency) const {
    const auto i = static_cast<Index>(std::lround(std::min(frequency / width_, 1e9)));
    if (i <= kNeighbours || i + kNeighbours >= power_.size()) {
      return false;
    }
    std::vector<double> beside = powersBeside(i);
    std::sort(beside.begin(), beside.end());
    return power_.segment(i - 1, 3).maxCoeff() > kLoud * kLoud * beside[beside.size() / 4];
  }

  // Returns the amplitude of the loudest neighbour, or infinity near the ends of the spectrum.
  double levelAt(double frequency) const {
    return std::sqrt(loudestBeside(static_cast<Index>(std::lround(std::min(frequency / width_, 1e9)))));
  }

 private:
  std::vector<double> powersBeside(Index i) const {
    std::vector<double> powers;
    for (Index j = std::max<Index>(1, i - kNeighbours); j <= i + kNeighbours; ++j) {
      if (std::abs(j - i) > kMainLobe) {
        powers.push_back(power_[j]);
      }
    }
    return powers;
  }

  double loudestBeside(Index i) const {
    if (i <= kNeighbours || i + kNeighbours >= power_.size()) {
      return HUGE_VAL;
    }
    const std::vector<double> powers = powersBeside(i);
    return *std::max_element(powers.begin(), powers.end());
  }

  template <class Level>
  std::vector<Line> linesAbove(Level level) const {
    std::vector<Line> lines;
    for (Index i = 1; i + kNeighbours < power_.size(); ++i) {
      const Index first = std::max<Index>(1, i - kMainLobe);
      const double beside = level(i);
      if (power_[i] > beside && power_[i] == power_.segment(first, i + kMainLobe + 1 - first).maxCoeff()) {
        const Line line = lineOver(i, beside);
        if (line.evidence > kLikely) {
          lines.push_back(line);
        }
      }
    }
    return lines;
  }

  // Computes the Bayes factor of a line relative to noise. If there is a line, the amplitudes of the blocks have a Rice
  // distribution, and the phase advance between blocks has a von Mises distribution. If there is only noise, the
  // amplitudes have a Rayleigh distribution, and the phase advance has a uniform distribution.
  Line lineOver(Index i, double beside) const {
    const double square = power_[i] - beside;
    const double variance = 0.5 * beside + kSteady * kSteady * square;  // variance of each of the two quadratures
    const double concentration = 1.0 / (kDrift * kDrift + beside / square);
    Complex advance = 0.0;
    double evidence = 0.0;
    for (Index b = 0; b < spectra_.rows(); ++b) {
      const double amplitude = std::abs(spectra_(b, i));
      evidence += std::log(0.5 * power_[i] / variance) - 0.5 * (amplitude * amplitude + square) / variance +
                  logBessel(amplitude * std::sqrt(square) / variance) + amplitude * amplitude / power_[i];
      const Complex turned = b > 0 ? spectra_(b, i) * std::conj(spectra_(b - 1, i)) : 0.0;
      advance += turned / std::max(std::abs(turned), 1e-300);
    }
    const auto steps = static_cast<double>(spectra_.rows() - 1);
    evidence += concentration * std::abs(advance) - steps * logBessel(concentration) - 0.5 * std::log(steps);
    double turns = std::arg(advance) / (2.0 * element::kPi);
    // Half-way between two frequencies the advance is ambiguous; the louder neighbour decides its sign.
    if (std::abs(turns) > 0.25 && turns * (power_[i + 1] - power_[i - 1]) < 0.0) {
      turns -= std::copysign(1.0, turns);
    }
    return {(static_cast<double>(i) + turns) * width_, std::sqrt(square), evidence};
  }

  double width_ = 0.0;
  Eigen::ArrayXXcd spectra_;  // complex amplitudes; one row per block, one column per frequency
  ArrayXd power_;             // squared amplitude at each frequency, averaged over the blocks
};

// Returns the smallest k for which k times `base` appears at this frequency, directly or as an alias, or else 0.
template <class Tolerance>
int multipleAt(double frequency, double base, double step, int highest, Tolerance tolerance) {
  for (int k = 1; k <= highest; ++k) {
    const double cycles = k * base * step;
    if (std::abs(std::abs(cycles - std::round(cycles)) / step - frequency) < tolerance(k * base)) {
      return k;
    }
  }
  return 0;
}

struct LineLog {
  LineLog(const log::Record& log, const VectorXd& simulated)
      : record(log),
        residual(log.force - simulated),
        spectra(residual, log.dt),
        lines(spectra.isolatedLines()),
        motion_spectra(log.displacement, log.dt),
        motion(motion_spectra.allLines()) {}

  const Line* lineAt(double frequency) const {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const Line& line) {
      return std::abs(line.frequency - frequency) < 0.5 * spectra.width();
    });
    return found == lines.end() ? nullptr : &*found;
  }

  // Returns true if the motion could cause a line at this frequency.
  bool mayMoveAt(double frequency) const {
    const auto isMultiple = [&](double of_motion, double base) {
      const auto resolved = [&](double) { return kResolved / record.duration(); };
      return multipleAt(of_motion, base, record.dt, kMultiples, resolved) > 0;
    };
    return motion_spectra.standsOutAt(frequency) || std::any_of(motion.begin(), motion.end(), [&](const Line& line) {
             return isMultiple(frequency, line.frequency) || !isMultiple(line.frequency, motion.front().frequency);
           });
  }

  const log::Record& record;
  VectorXd residual;
  BlockSpectra spectra;
  std::vector<Line> lines;
  BlockSpectra motion_spectra;
  std::vector<Line> motion;
};

// Returns true if the line is found in every log that should show it, and if the evidence of all logs together
// outweighs the low prior probability of a line at any one of the frequencies.
bool isOfRig(const Line& line, const std::vector<LineLog>& logs) {
  double evidence = -kRare;
  double frequencies = 1.0;
  for (const LineLog& log : logs) {
    if (log.mayMoveAt(line.frequency)) {
      continue;
    }
    const Line* shown = log.lineAt(line.frequency);
    if (shown == nullptr && line.amplitude > kLoud * log.spectra.levelAt(line.frequency)) {
      return false;
    }
    evidence += shown == nullptr ? 0.0 : shown->evidence;
    frequencies = std::max(frequencies, log.spectra.count());
  }
  return evidence > std::log(frequencies);
}

// Returns the lines of the rig in ascending order of frequency. Each is at least one frequency step from the others.
std::vector<Line> linesOfAll(const std::vector<LineLog>& logs) {
  std::vector<Line> candidates;
  for (const LineLog& log : logs) {
    candidates.insert(candidates.end(), log.lines.begin(), log.lines.end());
  }
  std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.evidence > b.evidence; });
  std::vector<Line> lines;
  for (const Line& candidate : candidates) {
    const bool known = std::any_of(lines.begin(), lines.end(), [&](const Line& line) {
      return std::abs(line.frequency - candidate.frequency) < logs.front().spectra.width();
    });
    if (!known && isOfRig(candidate, logs)) {
      lines.push_back(candidate);
    }
  }
  std::sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.frequency < b.frequency; });
  return lines;
}

// Returns ", harmonic 2 of 50.0 Hz" or ", perhaps 450 Hz, which 500 samples per second show there" if the line is a
// harmonic or an alias of another line or of mains. Otherwise returns an empty text.
std::string originOf(double frequency, double step, const std::vector<Line>& lines) {
  constexpr int kHighestHarmonic = 10;
  const auto held = [](double f) { return 2e-3 * f; };  // mains and rotating machines have a steady frequency
  std::vector<double> bases;
  for (const Line& line : lines) {
    if (line.frequency < 0.9 * frequency) {
      bases.push_back(line.frequency);
    }
  }
  bases.insert(bases.end(), {50.0, 60.0});
  for (const double base : bases) {
    const int k = multipleAt(frequency, base, step, kHighestHarmonic, held);
    if (k > 0 && k * base > 0.5 / step) {
      return fmt::format(", perhaps an alias of {:.0f} Hz at {:.4g} samples per second", k * base, 1.0 / step);
    }
    if (k > 0) {
      return k == 1 ? "" : fmt::format(", harmonic {} of {:.1f} Hz", k, base);
    }
  }
  return "";
}

// Returns the line at this frequency in a signal. Its phase is estimated in windows of a given length [s]. Its
// amplitude is estimated with this phase and written to `finding` together with its interval.
VectorXd lineIn(const VectorXd& signal, double step, double frequency, double window,
                measurement::RigFinding& finding) {
  const auto hop = static_cast<Index>(std::ceil(0.25 * window / step));
  const Index samples = signal.size();
  const ArrayXd weights = hannWindow(4 * hop);
  const ArrayXd phase =
      ArrayXd::LinSpaced(samples, 0.0, static_cast<double>(samples - 1)) * (2.0 * element::kPi * frequency * step);
  ArrayXcd carrier(samples);
  carrier.real() = phase.cos();
  carrier.imag() = phase.sin();
  const ArrayXcd turned = signal.array() * carrier.conjugate();
  ArrayXcd phasors(samples / hop + 2);
  for (Index i = 0; i < phasors.size(); ++i) {
    const Index begin = (i - 2) * hop;
    const Index first = std::max<Index>(0, begin);
    const Index count = std::min(samples, begin + 4 * hop) - first;
    phasors[i] = (turned.segment(first, count) * weights.segment(first - begin, count)).sum();
  }
  VectorXd line(samples);
  for (Index i = 0; i < samples; ++i) {
    const double place = static_cast<double>(i % hop) / static_cast<double>(hop);
    const Complex between = (1.0 - place) * phasors[i / hop] + place * phasors[i / hop + 1];
    line[i] = (carrier[i] * between).real() / std::max(std::abs(between), 1e-300);
  }
  constexpr Index kParts = 20;  // the scatter between 20 parts of the signal gives the interval of the amplitude
  constexpr double kNormal95 = 1.96;
  ArrayXd amplitudes(kParts);
  for (Index p = 0; p < kParts; ++p) {
    const Index first = samples * p / kParts;
    const Index count = samples * (p + 1) / kParts - first;
    amplitudes[p] = 2.0 * signal.segment(first, count).dot(line.segment(first, count)) / static_cast<double>(count);
  }
  const double value = amplitudes.mean();
  const double half = kNormal95 * std::sqrt((amplitudes - value).square().sum() / (kParts * (kParts - 1.0)));
  finding.value = value;
  finding.interval_95 = {value - half, value + half};
  return line * value;
}

}  // namespace

RigLines linesOfRig(const std::vector<log::Record>& records, const gap::Forces& simulated) {
  std::vector<LineLog> logs;
  for (std::size_t r = 0; r < records.size(); ++r) {
    if (simulated[r].allFinite()) {
      logs.emplace_back(records[r], simulated[r]);
    }
  }
  const std::vector<Line> lines = linesOfAll(logs);
  RigLines result;
  result.forces.resize(records.size());
  for (const LineLog& log : logs) {
    const double step = log.record.dt;
    VectorXd& force = result.forces[static_cast<std::size_t>(&log.record - records.data())];
    for (const Line& line : lines) {
      const Line* shown = log.lineAt(line.frequency);
      if (shown == nullptr) {
        continue;
      }
      measurement::RigFinding finding;
      const double window = std::max(kFewestCycles / shown->frequency, kShortestWindow / log.spectra.width());
      const VectorXd of_line = lineIn(log.residual, step, shown->frequency, window, finding);
      force = force.size() == 0 ? of_line : VectorXd(force + of_line);
      finding.log = log.record.name;
      finding.finding = measurement::finding::kLine;
      finding.unit = "N";
      finding.frequency = shown->frequency;
      finding.text = fmt::format("{:.1f} Hz, {:.{}f} N: mains or a pump{}", shown->frequency, finding.value,
                                 finding.value < 10.0 ? 2 : 0, originOf(shown->frequency, step, lines));
      result.findings.push_back(finding);
    }
  }
  return result;
}

}  // namespace rubber_suspension::diagnosis::prepare
