// Sign, unit factors, columns and component, judged by stiffness and energy of the whole log.
#include "rubber_suspension/measurement/bench_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "measurement/statistics.h"
#include "numerics/fourier.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::measurement {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// What effects can do to the stiffness of a whole log: friction raises it up to 3 times at small amplitude and 1.5
// times over all amplitudes, progressive stiffness doubles it; softening, free play, heat and a series compliance lower
// it to a third; with 15 % of tolerance of the specification on top.
constexpr double kLargestRatio = 3.5;
constexpr double kSmallestRatio = 0.3;
constexpr double kElastic =
    0.5;  // share of the force's variance that goes with the displacement, for a spring to be told
constexpr Index kFewestMoving = 30;
constexpr double kFewestPerCycle = 4.0;  // samples

// Stiffness over a quarter and half of a typical cycle: median of the slopes between pairs of samples, so that neither
// offsets and drifts nor bump stops and spikes count.
struct Slope {
  double stiffness = 0.0;    // [N/m]
  double correlation = 0.0;  // of both differences
};

// 2 pi times a typical frequency, per sample.
double typicalPhase(const VectorXd& displacement) {
  const Index count = displacement.size();
  const VectorXd step = displacement.tail(count - 1) - displacement.head(count - 1);
  return rmsOf(step) / std::max(deviationOf(displacement), 1e-300);
}

Slope slopeOf(const VectorXd& displacement, const VectorXd& force) {
  const Index count = displacement.size();
  const double smallest = 0.1 * rangeOf(displacement);
  std::vector<double> slopes;
  double zz = 0.0;
  double zf = 0.0;
  double ff = 0.0;
  for (const double phase : {0.5 * element::kPi, element::kPi}) {
    const double samples = phase / typicalPhase(displacement);
    const Index lag = std::clamp(static_cast<Index>(samples), Index{1}, count - 1);
    const Index stride = std::max<Index>(1, count / 20000);
    for (Index i = 0; i + lag < count; i += stride) {
      const double z = displacement[i + lag] - displacement[i];
      const double f = force[i + lag] - force[i];
      zz += z * z;
      zf += z * f;
      ff += f * f;
      if (std::abs(z) > smallest) {
        slopes.push_back(f / z);
      }
    }
  }
  const double scale = std::sqrt(zz * ff);
  return {slopes.empty() ? (zz > 0.0 ? zf / zz : 0.0) : medianOf(std::move(slopes)), scale > 0.0 ? zf / scale : 0.0};
}

// Cross-spectrum of displacement and force over octaves where the displacement is: mean over all half-overlapped Hann
// windows of a quarter of the log.
struct Octave {
  double frequency = 0.0;          // cycles per sample
  std::complex<double> cross = 0;  // conj(Z) F
  double power = 0.0;              // |Z|^2
};

class CrossSpectrum {
 public:
  CrossSpectrum(const VectorXd& displacement, const VectorXd& force) {
    const Index segment = std::max<Index>(16, displacement.size() / 4);
    for (Index begin = 0; begin + segment <= displacement.size(); begin += std::max<Index>(1, segment / 2)) {
      add(displacement.segment(begin, segment), force.segment(begin, segment));
    }
  }

  // Energy lost, as a share of the most that there could be, with the force brought forward by some samples; its
  // standard deviation by leaving out one window after the other.
  std::pair<double, double> loss(double forward) const {
    std::vector<double> energies;
    std::vector<double> scales;
    for (const auto& window : windows_) {
      double energy = 0.0;
      double scale = 0.0;
      for (const Octave& octave : window) {
        const std::complex<double> turned =
            octave.cross * std::polar(1.0, 2.0 * element::kPi * octave.frequency * forward);
        energy += octave.frequency * turned.imag();
        scale += octave.frequency * std::abs(octave.cross);
      }
      energies.push_back(energy);
      scales.push_back(scale);
    }
    return jackknife(energies, scales);
  }

  std::vector<Octave> octaves() const {
    std::vector<Octave> sum;
    for (const auto& window : windows_) {
      sum.resize(std::max(sum.size(), window.size()));
      for (std::size_t i = 0; i < window.size(); ++i) {
        sum[i].frequency = window[i].frequency > 0.0 ? window[i].frequency : sum[i].frequency;
        sum[i].cross += window[i].cross;
        sum[i].power += window[i].power;
      }
    }
    return sum;
  }

 private:
  static std::vector<std::complex<double>> spectrumOf(const VectorXd& values) {
    std::size_t padded = 16;
    while (padded < static_cast<std::size_t>(values.size())) {
      padded *= 2;
    }
    std::vector<double> windowed(padded, 0.0);
    const double mean = values.mean();
    for (Index i = 0; i < values.size(); ++i) {
      const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(values.size());
      windowed[static_cast<std::size_t>(i)] = (0.5 - 0.5 * std::cos(2.0 * element::kPi * place)) * (values[i] - mean);
    }
    return numerics::Fourier().halfSpectrum(windowed);
  }

  void add(const VectorXd& displacement, const VectorXd& force) {
    const auto z = spectrumOf(displacement);
    const auto f = spectrumOf(force);
    double most = 0.0;
    for (std::size_t i = 1; i < z.size(); ++i) {
      most = std::max(most, std::norm(z[i]));
    }
    std::vector<Octave> window;
    std::size_t end = 2;
    for (std::size_t begin = 1; begin < z.size(); begin = end, end = 2 * begin) {
      Octave octave;
      double weighted = 0.0;
      for (std::size_t i = begin; i < std::min(end, z.size()); ++i) {
        if (std::norm(z[i]) > 1e-3 * most) {  // excited: 30 dB below the highest line
          octave.cross += std::conj(z[i]) * f[i];
          octave.power += std::norm(z[i]);
          weighted += static_cast<double>(i) * std::norm(z[i]);
        }
      }
      octave.frequency = octave.power > 0.0 ? weighted / octave.power / static_cast<double>(2 * (z.size() - 1)) : 0.0;
      window.push_back(octave);
    }
    windows_.push_back(window);
  }

  static std::pair<double, double> jackknife(const std::vector<double>& energies, const std::vector<double>& scales) {
    double energy = 0.0;
    double scale = 0.0;
    for (std::size_t i = 0; i < energies.size(); ++i) {
      energy += energies[i];
      scale += scales[i];
    }
    if (scale <= 0.0) {
      return {0.0, 1.0};
    }
    double variance = 0.0;
    for (std::size_t i = 0; i < energies.size(); ++i) {
      const double without = scale > scales[i] ? (energy - energies[i]) / (scale - scales[i]) : energy / scale;
      variance += std::pow(without - energy / scale, 2);
    }
    const auto count = static_cast<double>(energies.size());
    return {energy / scale, std::sqrt(variance * (count - 1.0) / count)};
  }

  std::vector<std::vector<Octave>> windows_;
};

// How far measured phases are from those of a hypothesis, 0 to 2, weighted by the force.
template <class Phase>
double phaseDistance(const std::vector<Octave>& measured, const std::vector<Octave>& simulated, Phase phase) {
  double distance = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < std::min(measured.size(), simulated.size()); ++i) {
    const double weight = std::abs(measured[i].cross) * measured[i].frequency;
    if (weight > 0.0 && std::abs(simulated[i].cross) > 0.0) {
      const double expected = phase(std::arg(simulated[i].cross), measured[i].frequency);
      distance += weight * (1.0 - std::cos(std::arg(measured[i].cross) - expected));
      weights += weight;
    }
  }
  return weights > 0.0 ? distance / weights : 2.0;
}

// The late force of least distance, from so much of a typical period to three quarters of it: samples and distance.
std::pair<double, double> bestDelay(const std::vector<Octave>& measured, const std::vector<Octave>& simulated,
                                    double period, double least_share) {
  std::pair<double, double> best = {0.0, 2.0};
  for (int i = -30; i <= 30; ++i) {
    const double share = 0.025 * i;
    if (std::abs(share) < least_share) {
      continue;
    }
    const double delay = share * period;
    const double distance = phaseDistance(measured, simulated, [&](double phase, double frequency) {
      return phase - 2.0 * element::kPi * frequency * delay;
    });
    best = distance < best.second ? std::make_pair(delay, distance) : best;
  }
  return best;
}

// A factor between measured and configured stiffness, and what makes it.
struct UnitFactor {
  double factor;
  const char* correction;
};

constexpr UnitFactor kUnitFactors[] = {
    {1e3, "multiply the force by 0.001 (N taken for kN) or the displacement by 1000 (m taken for mm)"},
    {1e-3, "multiply the force by 1000 (kN taken for N) or the displacement by 0.001 (mm taken for m)"},
    {1e6, "multiply the force by 1e-6 (N taken for MN) or the displacement by 1e6 (m taken for um)"},
    {1e-6, "multiply the force by 1e6 (MN taken for N, or kN and mm taken for N and m) or the displacement by 1e-6"},
    {1e9, "multiply the force by 0.001 and the displacement by 1e6, or the like"},
    {1e-9, "multiply the force by 1000 and the displacement by 1e-6, or the like"},
    {9.81, "multiply the force by 0.102 (N taken for kgf), or divide it by 10 (daN)"},
    {1.0 / 9.81, "multiply the force by 9.81 (kgf taken for N), or by 10 (daN)"},
    {9810.0, "multiply the force by 0.102e-3 (N taken for tonnes)"},
    {1.0 / 9810.0, "multiply the force by 9810 (tonnes taken for N)"},
    {25.4, "multiply the displacement by 25.4 (inches taken for mm)"},
    {1.0 / 25.4, "divide the displacement by 25.4 (mm taken for inches)"},
    {4.448, "divide the force by 4.448 (N taken for lbf)"},
    {1.0 / 4.448, "multiply the force by 4.448 (lbf taken for N)"},
    {175.1, "divide the force by 4.448 and multiply the displacement by 39.37, or the like (lbf/in)"},
    {1.0 / 175.1, "multiply the force by 175.1 in all (lbf/in taken for N/mm)"},
    {100.0, "multiply the displacement by 100 or the force by 0.01 (cm taken for m, or the like)"},
    {0.01, "multiply the displacement by 0.01 or the force by 100 (cm taken for m, or the like)"},
};

const UnitFactor* unitFactorOf(double ratio) {
  // A factor of hundreds leaves room for what effects do; a small one only for the specification's tolerance and a
  // little friction, or it would explain any other component.
  const UnitFactor* best = nullptr;
  double least = HUGE_VAL;
  for (const UnitFactor& candidate : kUnitFactors) {
    const double off = std::abs(std::log(ratio / candidate.factor));
    const bool large = std::abs(std::log(candidate.factor)) > std::log(90.0);
    if (off < std::log(large ? 2.5 : 1.25) && off < least) {
      least = off;
      best = &candidate;
    }
  }
  return best;
}

bool plausible(double ratio) { return ratio > kSmallestRatio && ratio < kLargestRatio; }

struct Evidence {
  Slope measured;
  Slope configured;
  double ratio = 0.0;
  double loss = 0.0;  // of the measured loops, as a share of the most there could be; forward by 1.5 samples
  double loss_deviation = 0.0;
  double force_correlation = 0.0;  // of measured and simulated force
  double force_ratio = 0.0;        // of their standard deviations
  double period = 0.0;             // samples per typical cycle

  bool isElastic() const { return measured.correlation * measured.correlation > kElastic; }
  // By 3 standard deviations, and by more than a hundredth, which numbers alone may make.
  bool givesEnergy() const { return loss < -std::max(3.0 * loss_deviation, 0.01); }
};

RigFinding fatal(const std::string& log, const char* finding, double value, std::string text) {
  return {log, finding, value, {value, value}, "1", true, true, std::move(text)};
}

RigFinding fatal(const log::Record& record, const char* finding, double value, std::string text) {
  return fatal(record.name, finding, value, std::move(text));
}

// A ratio of stiffnesses that no effect makes. `remedy`: how the units can be named.
RigFinding ratioFinding(const std::string& log, double measured, double configured, const char* remedy) {
  const double ratio = measured / configured;
  if (const UnitFactor* factor = unitFactorOf(ratio)) {
    return fatal(log, finding::kUnitFactor, ratio,
                 fmt::format("the measured stiffness is {:.3g} times the configured one, as by the factor {:.4g} of a "
                             "wrong unit: {}; or {}",
                             ratio, factor->factor, factor->correction, remedy));
  }
  return fatal(
      log, finding::kOtherComponent, ratio,
      fmt::format("the measured stiffness {:.3g} N/m is {:.3g} times the configured {:.3g} N/m, more than tolerances "
                  "and effects explain ({:g} to {:g}) and no factor of units: check that measurement and component "
                  "file are of the same component",
                  measured, ratio, configured, kSmallestRatio, kLargestRatio));
}

RigFinding signFinding(const log::Record& record, const Evidence& e) {
  return fatal(
      record, finding::kSign, -1.0,
      fmt::format("the force falls where the displacement rises (stiffness {:.3g} N/m, configured {:.3g} N/m): "
                  "the sign of one is reversed; multiply the force by -1, --columns force=-NAME",
                  e.measured.stiffness, e.configured.stiffness));
}

RigFinding swapFinding(const log::Record& record, const Evidence& e) {
  return fatal(
      record, finding::kSwappedColumns, e.ratio,
      fmt::format("force and displacement look exchanged (stiffness {:.3g} N/m, configured {:.3g} N/m; loss {:.2g} "
                  "of a loop's most, negative: energy out of nothing): swap the columns, "
                  "--columns displacement=NAME force=NAME",
                  e.measured.stiffness, e.configured.stiffness, e.loss));
}

// At the record's mean temperature: what is checked are orders of magnitude.
VectorXd simulate(const component::Component& component, const VectorXd& displacement, const log::Record& record) {
  component::ComponentState state = component.makeState();
  if (record.temperature.size() > 0) {
    component.setTemperature(state, record.temperature.mean());
  }
  VectorXd force(displacement.size());
  force[0] = component.initialise(state, displacement[0]).total;
  component.simulate(state, record.dt, displacement.data() + 1, static_cast<std::size_t>(force.size() - 1),
                     force.data() + 1);
  return force;
}

// Length unit over force unit, in SI, by which the log is one of this component with the columns exchanged.
std::optional<double> unitsOfSwap(const component::Component& component, const log::Record& record) {
  for (const double units : {1.0, 1e-3, 1e-6, 1e-9}) {
    const VectorXd displacement = units * record.force;
    const VectorXd force = record.displacement / units;
    const VectorXd simulated = simulate(component, displacement, record);
    if (simulated.allFinite() &&
        plausible(slopeOf(displacement, force).stiffness / slopeOf(displacement, simulated).stiffness)) {
      return units;
    }
  }
  return std::nullopt;
}

// With the columns exchanged the log is one of this component, whatever the units that they were written in, and its
// loops do not say otherwise.
bool looksSwapped(const component::Component& component, const log::Record& record, const Evidence& e) {
  return e.loss <= 3.0 * e.loss_deviation && unitsOfSwap(component, record);
}

// The loops give energy or run backwards: which of sign, swap and delay has the phases that were measured.
std::optional<RigFinding> energyFinding(const component::Component& component, const log::Record& record,
                                        const VectorXd& simulated, const Evidence& e) {
  // Friction or damping far beyond the configured component: its phase says nothing about this one's; reversed, it is
  // the only force that gives energy.
  if (!e.isElastic() && !plausible(e.force_ratio)) {
    return signFinding(record, e);
  }
  const std::vector<Octave> measured = CrossSpectrum(record.displacement, record.force).octaves();
  const std::vector<Octave> expected = CrossSpectrum(record.displacement, simulated).octaves();
  const double sign = phaseDistance(measured, expected, [](double phase, double) { return phase + element::kPi; });
  const double swap = phaseDistance(measured, expected, [](double phase, double) { return -phase; });
  // As stiff as configured, and not with the columns exchanged: nothing but a delay, however short. What the effect
  // time_delay reaches is found among the effects.
  constexpr double kMostBehind = 15.0;     // samples, or
  constexpr double kLongestBehind = 0.03;  // [s], whichever is longer
  constexpr double kMostAhead = 4.0;       // samples
  constexpr double kClearlyLate = 0.124;   // of a period, where the sign or the columns may be wrong as well
  const bool only_delay = e.isElastic() && plausible(e.ratio) && !looksSwapped(component, record, e);
  const auto [delay, late] = bestDelay(measured, expected, e.period, only_delay ? 0.0 : kClearlyLate);
  if (only_delay && delay <= std::max(kMostBehind, kLongestBehind / record.dt) && delay >= -kMostAhead) {
    return std::nullopt;
  }
  // A delay has a free number; it has to be better than both by half a right angle's worth (1 - cos 45 deg).
  if (only_delay || late + 0.3 < std::min(sign, swap)) {
    return fatal(
        record, finding::kDelay, delay * record.dt,
        fmt::format("the loops give energy: the force is {:.3g} s {} the displacement, {:.2g} of a cycle: bring "
                    "both channels to one time",
                    std::abs(delay * record.dt), delay > 0.0 ? "behind" : "ahead of", std::abs(delay) / e.period));
  }
  return sign < swap ? signFinding(record, e) : swapFinding(record, e);
}

std::optional<RigFinding> stiffnessFinding(const component::Component& component, const log::Record& record,
                                           const Evidence& e) {
  if (!e.isElastic() || e.configured.stiffness <= 0.0 || e.measured.stiffness <= 0.0 || plausible(e.ratio)) {
    return std::nullopt;
  }
  // A factor may be both; what gives no energy is the simpler one.
  const UnitFactor* factor = unitFactorOf(e.ratio);
  if ((factor == nullptr || e.givesEnergy()) && looksSwapped(component, record, e)) {
    return swapFinding(record, e);
  }
  return ratioFinding(record.name, e.measured.stiffness, e.configured.stiffness,
                      "name the unit, as in --unit force=kN");
}

// Dampers: forces that go together, hundreds of times apart.
std::optional<RigFinding> forceFinding(const log::Record& record, const Evidence& e) {
  if (e.isElastic() || e.force_correlation < 0.8) {
    return std::nullopt;
  }
  const UnitFactor* factor = unitFactorOf(e.force_ratio);
  if (factor == nullptr || std::abs(std::log(factor->factor)) < std::log(90.0)) {
    return std::nullopt;
  }
  return fatal(
      record, finding::kUnitFactor, e.force_ratio,
      fmt::format("the measured force goes with the simulated one, but is {:.3g} times as large, as by the factor "
                  "{:.4g} of a wrong unit: {}; or name the unit, as in --unit force=kN",
                  e.force_ratio, factor->factor, factor->correction));
}

Evidence evidenceOf(const log::Record& record, const VectorXd& simulated) {
  Evidence e;
  e.measured = slopeOf(record.displacement, record.force);
  e.configured = slopeOf(record.displacement, simulated);
  e.ratio = e.configured.stiffness != 0.0 ? e.measured.stiffness / e.configured.stiffness : 0.0;
  // A delay of the force within what sensors have is no fault of the bench.
  constexpr double kForward = 1.5;  // samples
  std::tie(e.loss, e.loss_deviation) = CrossSpectrum(record.displacement, record.force).loss(kForward);
  const VectorXd one = record.force.array() - record.force.mean();
  const VectorXd other = simulated.array() - simulated.mean();
  const double scale = one.norm() * other.norm();
  e.force_correlation = scale > 0.0 ? one.dot(other) / scale : 0.0;
  e.force_ratio = other.norm() > 0.0 ? one.norm() / other.norm() : 0.0;
  e.period = 2.0 * element::kPi / typicalPhase(record.displacement);
  return e;
}

std::optional<RigFinding> lengthFinding(const log::Record& record) {
  const Index count = record.size();
  const VectorXd step = (record.displacement.tail(count - 1) - record.displacement.head(count - 1)).cwiseAbs();
  const Index moving = (step.array() > 0.01 * rmsOf(step)).count();
  if (moving < kFewestMoving) {
    return fatal(record, finding::kTooShort, static_cast<double>(moving),
                 fmt::format("{} samples in motion are too few; needed are {}: record longer, or at a higher rate",
                             moving, kFewestMoving));
  }
  const double per_cycle = 2.0 * element::kPi / typicalPhase(record.displacement);
  if (per_cycle < kFewestPerCycle) {
    return fatal(record, finding::kTooShort, per_cycle,
                 fmt::format("{:.2g} samples per cycle are too few; needed are {}: record at a higher rate", per_cycle,
                             kFewestPerCycle));
  }
  return std::nullopt;
}

// What a record cannot be, and whether nothing but the phase says so: it gives energy, and is as stiff as configured or
// only late; or nothing but stiffness that is too low by less than a power of ten, or negative, as a mass makes it in
// fast motion.
struct Checked {
  std::optional<RigFinding> finding;
  bool by_phase = false;
  bool as_by_mass = false;
};

Checked checkRecord(const component::Component& component, const log::Record& record) {
  if (auto too_short = lengthFinding(record)) {
    return {too_short};
  }
  const VectorXd simulated = simulate(component, record.displacement, record);
  if (!simulated.allFinite()) {
    return {};
  }
  const Evidence e = evidenceOf(record, simulated);
  const bool falls = e.measured.stiffness < 0.0 && e.measured.correlation * e.measured.correlation > kElastic;
  if (falls && e.configured.correlation > 0.0) {
    return {signFinding(record, e), false, true};
  }
  // Columns of exchanged size first: their loops give energy, too.
  if (auto stiffness = stiffnessFinding(component, record, e)) {
    constexpr double kLeastBesideMass = 0.1;
    const bool swapped = stiffness->finding == finding::kSwappedColumns;
    return {stiffness, false, !swapped && e.ratio > kLeastBesideMass && e.ratio < 1.0};
  }
  if (e.givesEnergy()) {
    auto finding = energyFinding(component, record, simulated, e);
    const bool late = finding && finding->finding == finding::kDelay;
    return {std::move(finding), late || (e.isElastic() && plausible(e.ratio))};
  }
  return {forceFinding(record, e)};
}

// A sign that is reversed, columns that are exchanged or a unit are so in all logs of a bench. Where fewer than half of
// them give energy, or are faster than most and less stiff, a delay or a mass has done it: that is found among the
// effects.
void leaveFastLogsToEffects(const std::vector<log::Record>& records, std::vector<Checked>& checked) {
  std::vector<double> frequencies;
  std::transform(records.begin(), records.end(), std::back_inserter(frequencies),
                 [](const log::Record& record) { return record.mean_frequency; });
  const double typical = medianOf(frequencies);
  const auto such = std::count_if(checked.begin(), checked.end(),
                                  [](const Checked& one) { return one.finding && (one.by_phase || one.as_by_mass); });
  if (2 * such >= static_cast<std::ptrdiff_t>(checked.size())) {
    return;
  }
  for (std::size_t i = 0; i < checked.size(); ++i) {
    if (checked[i].by_phase || (checked[i].as_by_mass && records[i].mean_frequency > typical)) {
      checked[i].finding.reset();
    }
  }
}

// The force brought forward by some samples; the ends that have no partner go.
void bringForward(Index samples, log::Record& record) {
  const Index count = record.size() - std::abs(samples);
  const Index of_force = std::max<Index>(samples, 0);
  const Index of_displacement = std::max<Index>(-samples, 0);
  record.force = VectorXd(record.force.segment(of_force, count));
  record.displacement = VectorXd(record.displacement.segment(of_displacement, count));
  record.raw_displacement = VectorXd(record.raw_displacement.segment(of_displacement, count));
  if (record.temperature.size() > 0) {
    record.temperature = VectorXd(record.temperature.segment(of_displacement, count));
  }
}

void exchangeColumns(double units, log::Record& record) {
  const VectorXd displacement = units * record.force;
  record.force = record.raw_displacement / units;
  record.displacement = record.raw_displacement = displacement;
}

}  // namespace

std::optional<BenchCorrection> correctionOf(const RigFinding& finding,
                                            const std::vector<element::ElementDescription>& elements,
                                            const log::Record& record) {
  BenchCorrection correction{"", record};
  if (finding.finding == finding::kSign) {
    correction.text = "force times -1";
    correction.record.force *= -1.0;
  } else if (finding.finding == finding::kUnitFactor) {
    const UnitFactor* factor = unitFactorOf(finding.value);
    if (factor == nullptr) {
      return std::nullopt;
    }
    correction.text = fmt::format("force divided by {:.4g}", factor->factor);
    correction.record.force /= factor->factor;
  } else if (finding.finding == finding::kSwappedColumns) {
    const auto units = unitsOfSwap(component::Component(elements), record);
    if (!units) {
      return std::nullopt;
    }
    correction.text = "columns exchanged";
    exchangeColumns(*units, correction.record);
  } else if (finding.finding == finding::kDelay && finding.fatal) {
    const auto samples = static_cast<Index>(std::lround(finding.value / record.dt));
    if (2 * std::abs(samples) > record.size()) {
      return std::nullopt;
    }
    correction.text = fmt::format("force brought forward by {:.3g} s", finding.value);
    bringForward(samples, correction.record);
  } else {
    return std::nullopt;
  }
  return correction;
}

std::optional<RigFinding> checkStiffness(const std::string& table, double measured, double configured) {
  return plausible(measured / configured)
             ? std::nullopt
             : std::optional(ratioFinding(table, measured, configured, "correct the unit in the header of the table"));
}

std::vector<RigFinding> checkBench(const std::vector<element::ElementDescription>& elements,
                                   const std::vector<log::Record>& records) {
  const component::Component component(elements);
  std::vector<Checked> checked;
  std::transform(records.begin(), records.end(), std::back_inserter(checked),
                 [&](const log::Record& record) { return checkRecord(component, record); });
  leaveFastLogsToEffects(records, checked);
  std::vector<RigFinding> findings;
  for (const Checked& one : checked) {
    if (one.finding) {
      findings.push_back(*one.finding);
    }
  }
  return findings;
}

}  // namespace rubber_suspension::measurement
