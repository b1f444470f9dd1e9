// Sign, unit factors, columns and component, judged by stiffness and work of the whole log.
#include "rubber_suspension/measurement/bench_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "gap/log_driver.h"
#include "measurement/loop_work.h"
#include "measurement/statistics.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/estimation/specification.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::measurement {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Limits of the change that effects make to the stiffness of a whole log: friction raises it up to 3 times at small
// amplitude and 1.5 times over all amplitudes, progressive stiffness doubles it; softening, free play, heat and a
// series compliance lower it to a third. The tolerance of the data sheet comes on top.
constexpr double kLargestRatio = 3.04;
constexpr double kSmallestRatio = 0.345;
constexpr double kDeviations = 1.4;  // of a data sheet that no effect need explain
constexpr double kElastic =
    0.5;  // share of the force's variance that goes with the displacement, for a spring to be told
constexpr Index kFewestMoving = 30;
constexpr double kFewestPerCycle = 4.0;  // samples
// Numbers alone may make a loop's work so much of the most that there could be.
constexpr double kNoWork = 0.01;
constexpr double kForward = 1.5;  // samples: the force of one channel behind the other is no fault of a bench
constexpr double kPeakToPeak = 2.0;

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

// A factor between measured and configured stiffness, and the units that make it, or its inverse.
struct UnitFactor {
  double factor;
  const char* units;
};

constexpr UnitFactor kUnitFactors[] = {
    {1e3, "N and kN, or mm and m"}, {1e6, "N and MN, um and m, or N/m and kN/mm"},
    {1e9, "N/m and kN/um"},         {9.81, "N and kgf or daN"},
    {9810.0, "N and tonnes"},       {25.4, "mm and inches"},
    {4.448, "N and lbf"},           {175.1, "N/m and lbf/in"},
    {39.37, "m and inches"},        {100.0, "cm and m"},
    {101.97, "kN and kgf"},         {224.8, "kN and lbf"},
};

// No effect makes factors as large.
bool isLarge(double factor) { return std::abs(std::log(factor)) > std::log(90.0); }

// The factor of units that is next to a ratio, within these tolerances.
std::optional<UnitFactor> unitFactorOf(double ratio, double of_large, double of_small) {
  std::optional<UnitFactor> best;
  double least = HUGE_VAL;
  for (const UnitFactor& candidate : kUnitFactors) {
    const double factor = ratio > 1.0 ? candidate.factor : 1.0 / candidate.factor;
    const double off = std::abs(std::log(ratio / factor));
    if (off < std::log(isLarge(factor) ? of_large : of_small) && off < least) {
      least = off;
      best = UnitFactor{factor, candidate.units};
    }
  }
  return best;
}

// Where nobody named the unit, a factor of hundreds leaves room for what effects do; a small one only for the
// specification's tolerance and a little friction, or it would explain any other component.
std::optional<UnitFactor> assumedFactorOf(double ratio) { return unitFactorOf(ratio, 2.5, 1.25); }

// The factor by which a data sheet may be off.
class SheetFactor {
 public:
  explicit SheetFactor(double tolerance) : factor_(std::exp(kDeviations * tolerance)) {}

  double least() const { return kSmallestRatio / factor_; }
  double most() const { return kLargestRatio * factor_; }
  bool plausible(double ratio) const { return ratio > least() && ratio < most(); }
  bool mayBe(double ratio) const { return std::abs(std::log(ratio)) < std::log(factor_); }

  // Where the units are named, a wrong one is unlikely: nothing but the sheet's tolerance, or, by hundreds, half of the
  // stiffness more.
  std::optional<UnitFactor> exactFactorOf(double ratio) const {
    return unitFactorOf(ratio, std::max(1.5, factor_), factor_);
  }

 private:
  double factor_;
};

const SheetFactor kUsualSheet(estimation::SheetTolerance::kUsual);

// Net work of the loops, as a share of the most that there could be.
struct Work {
  double recorded = 0.0;
  double forward = 0.0;   // with the force brought forward by what channels may be apart
  double backward = 0.0;  // with it put back as much
  double deviation = 0.0;

  double least() const { return std::max(3.0 * deviation, kNoWork); }
};

struct Evidence {
  SheetFactor sheet;
  Slope measured = {};
  Slope configured = {};
  double ratio = 0.0;
  Work work = {};
  double force_correlation = 0.0;  // of measured and simulated force
  double force_ratio = 0.0;        // of their standard deviations
  double period = 0.0;             // samples per typical cycle

  bool isElastic() const { return measured.correlation * measured.correlation > kElastic; }
  bool falls() const { return isElastic() && measured.stiffness < 0.0 && configured.correlation > 0.0; }
  bool rises() const { return isElastic() && measured.stiffness > 0.0; }
  bool givesEnergy() const { return work.forward < -work.least(); }
  bool takesEnergy() const { return work.forward > work.least() || work.recorded > 3.0 * work.deviation; }
  // Whatever the channels' delay.
  bool surelyGivesEnergy() const { return work.backward < -work.least(); }
  // The simulated force with the other sign, of whatever size: the stiffness may be a guess, or its unit a wrong one.
  bool isMirrored() const { return force_correlation < -0.9; }

  // The simulated force with the other sign, of next to no loss.
  bool fallsWithoutWork() const { return falls() && !takesEnergy() && isMirrored(); }
  // Too soft by less than a power of ten.
  bool asSoftAsByMass() const { return ratio > 0.1 && ratio < 1.0; }

  // By which the measured force is too large, if nothing else is wrong: of a damper by hundreds alone.
  std::optional<double> scale() const {
    if (isElastic()) {
      return configured.stiffness > 0.0 && measured.stiffness > 0.0 ? std::optional(ratio) : std::nullopt;
    }
    return force_correlation > 0.8 && isLarge(force_ratio) ? std::optional(force_ratio) : std::nullopt;
  }
};

constexpr double kClearPhase = 0.3;  // between distances of phases: half a right angle's worth, 1 - cos 45 deg

// Effects that look like a finding: a delay turns the phase alone, a mass in fast motion lowers or turns the
// stiffness. Both are effects, where most logs of a bench are right.
enum class LooksLike { nothing_else, delay, mass };

struct Suspicion {
  Suspicion(RigFinding named, LooksLike other = LooksLike::nothing_else)
      : finding(std::move(named)), looks_like(other) {}

  RigFinding finding;
  LooksLike looks_like;
};

// A log beside the component, and what is wrong with it.
struct Examined {
  gap::LogDriver& component;
  const log::Record& record;
  const SheetFactor& sheet;
  VectorXd simulated = {};
  std::optional<Evidence> evidence = std::nullopt;  // where its channels measured something
  std::optional<Suspicion> suspicion = std::nullopt;
};

RigFinding fatal(const std::string& log, const char* finding, double value, std::string text, const char* unit = "1") {
  return {log, finding, value, {value, value}, unit, true, true, std::move(text)};
}

constexpr const char* kCorrectTable = "correct the unit in the header of the table";

std::string columnsOf(double factor) {
  return fmt::format("--columns force={:.4g}*NAME or displacement={:.4g}*NAME", 1.0 / factor, factor);
}

// `remedy`: how the unit can be named.
RigFinding unitFinding(const std::string& log, double ratio, const UnitFactor& unit, const std::string& remedy) {
  return fatal(log, finding::kUnitFactor, ratio,
               fmt::format("the measured stiffness is {:.3g} times the configured one, as by the factor {:.4g} of a "
                           "wrong unit ({}): {}; if the units are right, --accept-units",
                           ratio, unit.factor, unit.units, remedy));
}

RigFinding unitFinding(const std::string& log, double ratio, const UnitFactor& unit) {
  return unitFinding(log, ratio, unit, "name the right one, as in --unit force=kN, or " + columnsOf(unit.factor));
}

RigFinding componentFinding(const std::string& log, double ratio, const SheetFactor& sheet, const std::string& logs) {
  return fatal(log, finding::kOtherComponent, ratio,
               fmt::format("the measured stiffness is {:.3g} times the configured one{}, more than tolerances and "
                           "effects explain ({:.2g} to {:.2g}), and no factor of units: check that measurement and "
                           "component file are of the same component; if they are, --accept-units",
                           ratio, logs, sheet.least(), sheet.most()));
}

RigFinding peakToPeakFinding(const std::string& log, double ratio, const std::string& remedy) {
  return fatal(
      log, finding::kPeakToPeak, ratio,
      fmt::format(
          "the measured stiffness is {:.3g} times the configured one in all motions, and nothing else differs: the {} "
          "is a value from peak to peak, or {} components are clamped: {}; if it is right, --accept-units",
          ratio, ratio > 1.0 ? "force" : "displacement", ratio > 1.0 ? "two parallel" : "two such in a row of",
          remedy));
}

RigFinding signFinding(const log::Record& record, const Evidence& e) {
  return fatal(
      record.name, finding::kSign, -1.0,
      fmt::format("the force falls where the displacement rises (stiffness {:.3g} N/m, configured {:.3g} N/m), "
                  "and its loops take no energy ({:.2g} of the most that there could be), which a mass in fast "
                  "motion would: the sign of one channel is reversed; multiply it by -1, --columns force=-NAME{}",
                  e.measured.stiffness, e.configured.stiffness, e.work.recorded,
                  e.ratio >= 0.0 || e.sheet.plausible(-e.ratio)
                      ? ""
                      : fmt::format("; besides, the measured stiffness is {:.3g} times the configured one: check the "
                                    "units and the component file",
                                    -e.ratio)));
}

RigFinding swapFinding(const log::Record& record, const Evidence& e) {
  return fatal(
      record.name, finding::kSwappedColumns, e.ratio,
      fmt::format("force and displacement look exchanged (stiffness {:.3g} N/m, configured {:.3g} N/m; loss {:.2g} "
                  "of a loop's most, negative: energy out of nothing): swap the columns, "
                  "--columns displacement=NAME force=NAME",
                  e.measured.stiffness, e.configured.stiffness, e.work.forward));
}

// From rest, without the motion across: what is checked are orders of magnitude.
VectorXd simulate(gap::LogDriver& component, const VectorXd& displacement, const log::Record& record) {
  log::Record from_rest;
  from_rest.dt = record.dt;
  from_rest.temperature = record.temperature;
  return component.over(from_rest, displacement, gap::Before::nothing);
}

// Length unit over force unit, in SI, by which the log is one of this component with the columns exchanged.
std::optional<double> unitsOfSwap(gap::LogDriver& component, const log::Record& record, const SheetFactor& sheet) {
  for (const double units : {1.0, 1e-3, 1e-6, 1e-9}) {
    const VectorXd displacement = units * record.force;
    const VectorXd force = record.displacement / units;
    const VectorXd simulated = simulate(component, displacement, record);
    if (simulated.allFinite() &&
        sheet.plausible(slopeOf(displacement, force).stiffness / slopeOf(displacement, simulated).stiffness)) {
      return units;
    }
  }
  return std::nullopt;
}

// With the columns exchanged the log is one of this component, whatever the units that they were written in, and its
// loops do not say otherwise.
bool looksSwapped(gap::LogDriver& component, const log::Record& record, const Evidence& e) {
  return e.work.forward <= 3.0 * e.work.deviation && unitsOfSwap(component, record, e.sheet);
}

// Distance of the measured phases from those of the simulated force with the other sign.
double distanceOfSign(const std::vector<Octave>& measured, const std::vector<Octave>& expected) {
  return phaseDistance(measured, expected, [](double phase, double) { return phase + element::kPi; });
}

// The loops give energy or run backwards, at a stiffness that is right: which of sign, swap and delay has the phases
// that were measured.
std::optional<Suspicion> energySuspicion(const Examined& log) {
  const log::Record& record = log.record;
  const Evidence& e = *log.evidence;
  if (e.falls() || !e.givesEnergy() || (e.scale() && !e.sheet.plausible(*e.scale()))) {
    return std::nullopt;
  }
  const LooksLike looks_like = e.isElastic() && e.sheet.plausible(e.ratio) ? LooksLike::delay : LooksLike::nothing_else;
  // Friction or damping far beyond the configured component: its phase says nothing about this one's; reversed, it is
  // the only force that gives energy.
  if (!e.isElastic() && !e.sheet.plausible(e.force_ratio)) {
    return Suspicion{signFinding(record, e), looks_like};
  }
  const std::vector<Octave> measured = CrossSpectrum(record.displacement, record.force).octaves();
  const std::vector<Octave> expected = CrossSpectrum(record.displacement, log.simulated).octaves();
  const double sign = distanceOfSign(measured, expected);
  const double swap = phaseDistance(measured, expected, [](double phase, double) { return -phase; });
  // As stiff as configured, and not with the columns exchanged: nothing but a delay, however short. What the effect
  // time_delay reaches is found among the effects.
  constexpr double kMostBehind = 15.0;     // samples, or
  constexpr double kLongestBehind = 0.03;  // [s], whichever is longer
  constexpr double kMostAhead = 4.0;       // samples
  constexpr double kClearlyLate = 0.124;   // of a period, where the sign or the columns may be wrong as well
  const bool only_delay = looks_like == LooksLike::delay && !looksSwapped(log.component, record, e);
  const auto [delay, late] = bestDelay(measured, expected, e.period, only_delay ? 0.0 : kClearlyLate);
  if (only_delay && delay <= std::max(kMostBehind, kLongestBehind / record.dt) && delay >= -kMostAhead) {
    return std::nullopt;
  }
  // A delay has a free number; it has to be better than both.
  if (only_delay || late + kClearPhase < std::min(sign, swap)) {
    const std::string text = fmt::format(
        "the loops give energy: the force is {:.3g} s {} the displacement, {:.2g} of a cycle: bring both "
        "channels to one time",
        std::abs(delay * record.dt), delay > 0.0 ? "behind" : "ahead of", std::abs(delay) / e.period);
    return Suspicion{fatal(record.name, finding::kDelay, delay * record.dt, text, "s"), LooksLike::delay};
  }
  return Suspicion{sign < swap ? signFinding(record, e) : swapFinding(record, e), looks_like};
}

// True if the phases are those of a mass that inverts the stiffness at the log's mean frequency, but not in slow
// motion.
bool isTurnedAsByMass(const log::Record& record, const VectorXd& simulated, const Evidence& e) {
  const std::vector<Octave> measured = CrossSpectrum(record.displacement, record.force).octaves();
  const std::vector<Octave> expected = CrossSpectrum(record.displacement, simulated).octaves();
  std::vector<Octave> with_mass = expected;
  for (Octave& octave : with_mass) {
    const double times = octave.frequency / (record.mean_frequency * record.dt);
    octave.cross -= (e.configured.stiffness - e.measured.stiffness) * times * times * octave.power;
  }
  const double mass = phaseDistance(measured, with_mass, [](double phase, double) { return phase; });
  const double sign = distanceOfSign(measured, expected);
  return mass < sign + kClearPhase;
}

// The force falls where the displacement rises.
std::optional<Suspicion> signSuspicion(const Examined& log) {
  const Evidence& e = *log.evidence;
  if (!e.falls() || !e.surelyGivesEnergy()) {
    return std::nullopt;
  }
  return Suspicion{signFinding(log.record, e),
                   isTurnedAsByMass(log.record, log.simulated, e) ? LooksLike::mass : LooksLike::nothing_else};
}

// The unit of a channel, where nobody named it.
std::optional<Suspicion> unitSuspicion(const Examined& log) {
  const Evidence& e = *log.evidence;
  const auto scale = e.scale();
  const bool ask = log.record.units == log::UnitsAre::assumed && scale && !log.sheet.plausible(*scale);
  const auto unit = ask ? assumedFactorOf(*scale) : std::nullopt;
  return unit ? std::optional(Suspicion{unitFinding(log.record.name, *scale, *unit),
                                        e.asSoftAsByMass() ? LooksLike::mass : LooksLike::nothing_else})
              : std::nullopt;
}

// Columns of exchanged size.
std::optional<Suspicion> exchangeSuspicion(const Examined& log) {
  const Evidence& e = *log.evidence;
  if (!e.rises() || e.configured.stiffness <= 0.0 || e.sheet.plausible(e.ratio)) {
    return std::nullopt;
  }
  // A factor may be both; what gives no energy is the simpler one.
  const bool exchanged = (!assumedFactorOf(e.ratio) || e.givesEnergy()) && looksSwapped(log.component, log.record, e);
  return exchanged ? std::optional(Suspicion{swapFinding(log.record, e)}) : std::nullopt;
}

Evidence evidenceOf(const log::Record& record, const VectorXd& simulated, const SheetFactor& sheet) {
  constexpr double kLargestShare = 0.02;  // of a cycle
  Evidence e{sheet};
  e.measured = slopeOf(record.displacement, record.force);
  e.configured = slopeOf(record.displacement, simulated);
  e.ratio = e.configured.stiffness != 0.0 ? e.measured.stiffness / e.configured.stiffness : 0.0;
  e.period = 2.0 * element::kPi / typicalPhase(record.displacement);
  const CrossSpectrum spectrum(record.displacement, record.force);
  const double apart = e.measured.stiffness < 0.0 ? std::min(kForward, kLargestShare * e.period) : kForward;
  e.work.recorded = spectrum.work(0.0).first;
  e.work.backward = spectrum.work(-apart).first;
  std::tie(e.work.forward, e.work.deviation) = spectrum.work(apart);
  e.force_correlation = correlationOf(record.force, simulated);
  const double simulated_deviation = gap::standardDeviation(simulated);
  e.force_ratio = simulated_deviation > 0.0 ? gap::standardDeviation(record.force) / simulated_deviation : 0.0;
  return e;
}

// True if the force at a constant displacement exceeds its part that no motion causes, such as hum, which continues in
// a hold.
bool isOfAMotion(const log::Record& record, const DeadPart& dead) {
  constexpr double kMore = 1.25;  // two parts of a log tell a hum within a quarter
  const Index length = dead.end - dead.begin;
  return gap::standardDeviation(record.force.segment(dead.begin, length)) >
         kMore * deviationOfNoMotion(record.raw_displacement, record.force, dead);
}

// True if a constant force is that of an open contact: it is the least of its sign, and the displacement is beyond all
// with more force.
bool isOfASlackContact(const log::Record& record, const DeadPart& dead) {
  constexpr double kStill = 0.01;  // of the range: twice what a part may have that stands still
  const auto part = [&](const VectorXd& column) { return column.segment(dead.begin, dead.end - dead.begin); };
  const double still = kStill * rangeOf(record.force);
  const double slack = part(record.force).mean();
  const auto isOfSide = [&](double side) {
    const auto carries = side * (record.force.array() - slack) > still;
    const double least = carries.select(side * record.displacement.array(), HUGE_VAL).minCoeff();
    return (side * (record.force.array() - slack)).minCoeff() >= -still &&
           (side * part(record.displacement).array()).maxCoeff() <= least;
  };
  return isOfSide(1.0) || isOfSide(-1.0);
}

// A channel that measured nothing, all along or in a part of the log.
std::optional<Suspicion> constantSuspicion(const Examined& log) {
  const log::Record& record = log.record;
  constexpr double kAsMuch = 0.5;   // of the force's deviation in the rest
  constexpr double kFarther = 0.8;  // of the displacement's: less may be within a free play
  for (const bool is_force : {false, true}) {
    const VectorXd& channel = is_force ? record.force : record.raw_displacement;
    const VectorXd& other = is_force ? record.raw_displacement : record.force;
    const char* const name = is_force ? "force" : "displacement";
    const char* const unit = is_force ? "N" : "m";
    if (rangeOf(channel) <= 1e-12 * channel.cwiseAbs().maxCoeff()) {
      return fatal(record.name, finding::kConstant, channel[0],
                   fmt::format("the {} is {:.4g} {} from the first sample to the last: check the channel's cable, and "
                               "which column it is, --columns {}=NAME",
                               name, channel[0], unit, name),
                   unit);
    }
    const DeadPart dead = deadPart(channel, other, is_force ? kFarther : kAsMuch);
    if (dead.end > dead.begin && (is_force ? !isOfASlackContact(record, dead) : isOfAMotion(record, dead))) {
      const auto time = [&](Index sample) { return static_cast<double>(sample) * record.dt; };
      return fatal(
          record.name, finding::kConstant, time(dead.end - dead.begin),
          fmt::format("the {} stands still from {:.4g} to {:.4g} s of {:.4g} s, while the {} continues: check "
                      "the channel's cable, and leave this part out",
                      name, time(dead.begin), time(dead.end), record.duration(), is_force ? "displacement" : "force"),
          "s");
    }
  }
  return std::nullopt;
}

// By which a displacement changes over so many samples.
VectorXd wayOver(const VectorXd& displacement, Index samples) {
  const Index count = std::max<Index>(1, displacement.size() - samples);
  return displacement.tail(count) - displacement.head(count);
}

// Noise alone, of next to nothing, neither with the displacement nor with its direction as friction is, where the
// component has a force.
std::optional<Suspicion> silenceSuspicion(const Examined& log) {
  const log::Record& record = log.record;
  const Evidence& e = *log.evidence;
  constexpr double kNothing = 0.05;    // of the simulated force
  constexpr double kUnrelated = 0.15;  // correlation
  const VectorXd way = wayOver(record.displacement, std::max<Index>(1, std::lround(e.period / 8.0)));
  const VectorXd force = record.force.tail(way.size());
  const bool related = std::abs(e.force_correlation) > kUnrelated ||
                       std::abs(correlationOf(record.displacement, record.force)) > kUnrelated ||
                       std::abs(correlationOf(way, force)) > kUnrelated ||
                       std::abs(correlationOf(way.cwiseSign(), force)) > kUnrelated;
  if (related || e.force_ratio > kNothing || record.units == log::UnitsAre::accepted) {
    return std::nullopt;
  }
  return fatal(
      record.name, finding::kConstant, e.force_ratio,
      fmt::format("the force does not answer to the displacement: it scatters by {:.3g} N, {:.2g} % of what the "
                  "component gives: check the clamps and the channel's cable",
                  record.force_deviation, 100.0 * e.force_ratio));
}

constexpr double kFollows = 0.7;   // correlation of a force with what it is taken for
constexpr double kClearly = 0.35;  // of the variance: more than what it should follow explains

// A channel without its sign follows the magnitude of the other, and not the other.
std::optional<Suspicion> rectifiedSuspicion(const Examined& log) {
  const log::Record& record = log.record;
  const Evidence& e = *log.evidence;
  const double of_force = correlationOf(record.force, log.simulated.cwiseAbs());
  const VectorXd magnitude = (record.force.array() - record.force.mean()).abs();
  const double of_displacement = correlationOf(record.displacement, magnitude);
  const double as_recorded = std::max(std::pow(e.force_correlation, 2), std::pow(e.measured.correlation, 2));
  for (const auto& [name, correlation] : {std::pair("force", of_force), {"displacement", of_displacement}}) {
    if (correlation > kFollows && correlation * correlation > as_recorded + kClearly) {
      return fatal(record.name, finding::kRectified, correlation,
                   fmt::format("the {} has lost its sign: it follows the magnitude of what belongs to it (correlation "
                               "{:.2f}, with the sign {:.2f}): record it unrectified",
                               name, correlation, e.force_correlation));
    }
  }
  return std::nullopt;
}

std::optional<Suspicion> lengthSuspicion(const Examined& log) {
  const log::Record& record = log.record;
  const Index count = record.size();
  const VectorXd step = (record.displacement.tail(count - 1) - record.displacement.head(count - 1)).cwiseAbs();
  const Index moving = (step.array() > 0.01 * rmsOf(step)).count();
  if (moving < kFewestMoving) {
    // A step that is held, as of relaxation or creep, is not seen better in a longer log.
    const bool held = 2 * moving < count;
    return fatal(record.name, finding::kTooShort, static_cast<double>(moving),
                 fmt::format("{} samples in motion are too few; needed are {}: {}", moving, kFewestMoving,
                             held ? fmt::format("the displacement rests in the other {}: record the motion between at "
                                                "a higher rate, or add a log that moves",
                                                count - moving)
                                  : "record longer, or at a higher rate"));
  }
  const double per_cycle = 2.0 * element::kPi / typicalPhase(record.displacement);
  if (per_cycle < kFewestPerCycle) {
    return fatal(record.name, finding::kTooShort, per_cycle,
                 fmt::format("{:.2g} samples per cycle are too few; needed are {}: record at a higher rate", per_cycle,
                             kFewestPerCycle));
  }
  return std::nullopt;
}

// The checks of one log: each asks one question, and the first that is answered names what is wrong. First of the
// channels as they were recorded, then of the force beside the simulated one; and last of loops: columns of exchanged
// size before units and energy, since their loops give energy, too.
using Check = std::optional<Suspicion> (*)(const Examined& log);
constexpr Check kOfChannels[] = {constantSuspicion, lengthSuspicion};
constexpr Check kOfForces[] = {rectifiedSuspicion, silenceSuspicion};
constexpr Check kOfLoops[] = {signSuspicion, exchangeSuspicion, unitSuspicion, energySuspicion};

template <std::size_t count>
bool findsFault(const Check (&checks)[count], Examined& log) {
  return std::any_of(checks, checks + count, [&](Check check) {
    log.suspicion = check(log);
    return log.suspicion.has_value();
  });
}

Examined examine(gap::LogDriver& component, const log::Record& record, const SheetFactor& sheet) {
  Examined log{component, record, sheet};
  if (findsFault(kOfChannels, log)) {
    return log;
  }
  log.simulated = simulate(component, record.displacement, record);
  if (!log.simulated.allFinite()) {
    return log;
  }
  log.evidence = evidenceOf(record, log.simulated, sheet);
  if (findsFault(kOfForces, log)) {
    log.evidence.reset();
  } else {
    findsFault(kOfLoops, log);
  }
  return log;
}

// A reversed sign, exchanged columns or a wrong unit affect all logs of a bench. If fewer than half of them create
// energy, or are faster than all right ones and less stiff, the cause is a delay or a mass, which are effects.
void leaveFastLogsToEffects(std::vector<Examined>& logs) {
  double fastest_right = 0.0;  // [Hz]
  for (const Examined& log : logs) {
    fastest_right = log.suspicion ? fastest_right : std::max(fastest_right, log.record.mean_frequency);
  }
  const auto looksLikeAnEffect = [](const Examined& log) {
    return log.suspicion && log.suspicion->looks_like != LooksLike::nothing_else;
  };
  if (2 * std::count_if(logs.begin(), logs.end(), looksLikeAnEffect) >= static_cast<std::ptrdiff_t>(logs.size())) {
    return;
  }
  for (Examined& log : logs) {
    const bool fast = log.record.mean_frequency > fastest_right;
    if (looksLikeAnEffect(log) && (fast || log.suspicion->looks_like == LooksLike::delay)) {
      log.suspicion.reset();
    }
  }
}

// A spring with next to no loss tells nothing by its work. Its force with the other sign is that of a reversed channel,
// where no log that is slower has the right one, as a mass would turn the fast logs first, or where none has its
// phases.
void nameReversedSprings(std::vector<Examined>& logs) {
  double slowest_right = HUGE_VAL;  // [Hz]
  for (const Examined& log : logs) {
    const bool right = log.evidence && (log.evidence->rises() || log.evidence->takesEnergy());
    slowest_right = right ? std::min(slowest_right, log.record.mean_frequency) : slowest_right;
  }
  for (Examined& log : logs) {
    if (log.evidence && log.evidence->fallsWithoutWork() && !log.suspicion &&
        (log.record.mean_frequency < slowest_right || !isTurnedAsByMass(log.record, log.simulated, *log.evidence))) {
      log.suspicion = signFinding(log.record, *log.evidence);
    }
  }
}

// The scale of a log whose units the file or the user named.
struct Scaled {
  Examined* log;
  double scale;
};

std::vector<Scaled> scalesOf(std::vector<Examined>& logs) {
  std::vector<Scaled> scales;
  for (Examined& log : logs) {
    const auto scale = log.evidence && !log.suspicion ? log.evidence->scale() : std::nullopt;
    if (scale && log.record.units != log::UnitsAre::accepted) {
      scales.push_back({&log, *scale});
    }
  }
  return scales;
}

double medianScale(const std::vector<Scaled>& scales) {
  std::vector<double> values;
  std::transform(scales.begin(), scales.end(), std::back_inserter(values), [](const Scaled& s) { return s.scale; });
  return medianOf(std::move(values));
}

bool isAboutTwo(double ratio) {
  constexpr double kExactly = 1.04;
  return std::abs(std::abs(std::log(ratio)) - std::log(kPeakToPeak)) < std::log(kExactly);
}

// One factor in all logs, which leaves the force like the configured one in all else.
void nameCommonScale(const std::vector<Scaled>& scales, const SheetFactor& sheet) {
  constexpr double kOne = 1.5;         // between two logs: what frequency and amplitude make of it
  constexpr double kLike = 0.8;        // correlation
  constexpr double kJustLike = 0.995;  // for a factor that a wrong specification may make as well
  const double common = medianScale(scales);
  const auto isOfAll = [&](double likeness, const auto& holds) {
    return std::all_of(scales.begin(), scales.end(), [&](const Scaled& s) {
      return holds(s.scale) && std::abs(std::log(s.scale / common)) < std::log(kOne) &&
             s.log->evidence->force_correlation > likeness;
    });
  };
  const auto unit = sheet.exactFactorOf(common);
  const bool one = isOfAll(kLike, [&](double scale) { return !sheet.plausible(scale); });
  const bool two = !sheet.mayBe(kPeakToPeak) && isOfAll(kJustLike, isAboutTwo) && isAboutTwo(common);
  const std::string logs = scales.size() == 1 ? "" : fmt::format(", in all {} logs alike", scales.size());
  for (const Scaled& s : scales) {
    const std::string& name = s.log->record.name;
    if (one) {
      s.log->suspicion = unit ? unitFinding(name, s.scale, *unit) : componentFinding(name, s.scale, sheet, logs);
    } else if (two) {
      s.log->suspicion = peakToPeakFinding(
          name, s.scale, fmt::format("--columns {}=0.5*NAME", common > 1.0 ? "force" : "displacement"));
    }
  }
}

// A log among others that are plausible, off by hundreds: no effect does that.
void nameOddScales(const std::vector<Scaled>& scales, const SheetFactor& sheet) {
  std::vector<Scaled> right;
  std::copy_if(scales.begin(), scales.end(), std::back_inserter(right),
               [&](const Scaled& s) { return sheet.plausible(s.scale); });
  for (const Scaled& s : scales) {
    const auto unit = right.empty() ? std::nullopt : kUsualSheet.exactFactorOf(s.scale / medianScale(right));
    if (unit && isLarge(unit->factor)) {
      s.log->suspicion = unitFinding(s.log->record.name, s.scale, *unit);
    }
  }
}

// The force brought forward by some samples; the ends that have no partner go.
void bringForward(Index samples, log::Record& record) {
  const Index count = record.size() - std::abs(samples);
  const Index of_force = std::max<Index>(samples, 0);
  const Index of_displacement = std::max<Index>(-samples, 0);
  record.force = VectorXd(record.force.segment(of_force, count));
  for (VectorXd* channel : {&record.displacement, &record.raw_displacement, &record.temperature, &record.across}) {
    if (channel->size() > 0) {
      *channel = VectorXd(channel->segment(of_displacement, count));
    }
  }
}

void exchangeColumns(double units, log::Record& record) {
  const VectorXd displacement = units * record.force;
  record.force = record.raw_displacement / units;
  record.displacement = record.raw_displacement = displacement;
}

// True if an element yields to one sign of force alone, such as a contact that opens.
bool isContact(const element::ElementDescription& description) {
  const element::ElementPointer element = element::makeElement(description);
  const auto* const series = std::get_if<std::shared_ptr<const element::SeriesElement>>(&element);
  const auto compliance = series != nullptr ? (*series)->compliance() : std::nullopt;
  return compliance && (compliance->tension == 0.0) != (compliance->compression == 0.0);
}

// The component with its contacts on the other side, and the type of the last one; nothing without any.
struct TurnedContacts {
  gap::LogDriver component;
  std::string type;
};

std::optional<TurnedContacts> withContactsTurned(std::vector<element::ElementDescription> elements) {
  std::string type;
  for (element::ElementDescription& element : elements) {
    if (isContact(element)) {
      element.values["side"] = {-element.value("side")};
      type = element.type;
    }
  }
  return type.empty() ? std::nullopt : std::optional(TurnedContacts{gap::LogDriver(elements), type});
}

// The force is that of the component whose contact carries the other sign, whatever the log seems to be then: as
// configured the contact is open where the log has a force.
void nameTurnedContact(TurnedContacts& turned, Examined& log) {
  const log::Record& record = log.record;
  const double as_configured =
      std::max(0.0, correlationOf(record.force, simulate(log.component, record.displacement, record)));
  const double as_turned = correlationOf(record.force, simulate(turned.component, record.displacement, record));
  if (as_turned > kFollows && as_turned * as_turned > as_configured * as_configured + kClearly) {
    log.suspicion =
        fatal(record.name, finding::kContactSide, as_turned,
              fmt::format("the contact `{}` of the component is open where this log has a force, which follows the "
                          "component with `side` of the other sign (correlation {:.2f}, as configured {:.2f}): correct "
                          "`side`, or the signs of displacement and force",
                          turned.type, as_turned, as_configured));
  }
}

}  // namespace

std::optional<BenchCorrection> correctionOf(const RigFinding& finding,
                                            const std::vector<element::ElementDescription>& elements,
                                            const log::Record& record) {
  BenchCorrection correction{"", record};
  if (finding.finding == finding::kSign) {
    correction.text = "force times -1";
    correction.record.force *= -1.0;
  } else if (finding.finding == finding::kUnitFactor || finding.finding == finding::kPeakToPeak) {
    const auto unit = assumedFactorOf(finding.value);
    const double two = finding.value > 1.0 ? kPeakToPeak : 1.0 / kPeakToPeak;
    const double factor = unit ? unit->factor : two;
    correction.text = fmt::format("force divided by {:.4g}", factor);
    correction.record.force /= factor;
  } else if (finding.finding == finding::kSwappedColumns) {
    gap::LogDriver component(elements);
    const auto units = unitsOfSwap(component, record, kUsualSheet);
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

bool isFarOff(const RigFinding& finding) {
  const bool of_stiffness = finding.finding == finding::kUnitFactor || finding.finding == finding::kOtherComponent ||
                            finding.finding == finding::kPeakToPeak;
  return of_stiffness && isLarge(std::abs(finding.value));
}

std::optional<RigFinding> checkTable(const std::string& table, const std::vector<std::complex<double>>& measured,
                                     const std::vector<std::complex<double>>& configured, double tolerance) {
  const auto gains_energy = [](const std::complex<double>& stiffness) { return stiffness.imag() < 0.0; };
  if (!measured.empty() && std::all_of(measured.begin(), measured.end(), gains_energy)) {
    return fatal(table, finding::kSign, -1.0,
                 "all loss angles are negative, which gives energy: the sign of the phase is that of the other "
                 "convention, or force and displacement are exchanged: change it in the table");
  }
  const SheetFactor sheet(tolerance);
  std::vector<double> sizes;
  std::vector<double> configured_sizes;
  std::vector<double> ratios;
  for (std::size_t r = 0; r < measured.size(); ++r) {
    sizes.push_back(std::abs(measured[r]));
    configured_sizes.push_back(std::abs(configured[r]));
    ratios.push_back(sizes[r] / configured_sizes[r]);
  }
  const double ratio = medianOf(sizes) / medianOf(configured_sizes);
  if (!sheet.mayBe(kPeakToPeak) && std::all_of(ratios.begin(), ratios.end(), isAboutTwo) && isAboutTwo(ratio)) {
    return peakToPeakFinding(table, ratio, "halve what is from peak to peak");
  }
  if (sheet.plausible(ratio)) {
    return std::nullopt;
  }
  const auto unit = assumedFactorOf(ratio);
  return unit ? unitFinding(table, ratio, *unit, kCorrectTable) : componentFinding(table, ratio, sheet, "");
}

std::vector<RigFinding> checkBench(const std::vector<element::ElementDescription>& elements,
                                   const std::vector<log::Record>& records, double tolerance) {
  gap::LogDriver component(elements);
  const SheetFactor sheet(tolerance);
  std::vector<Examined> logs;
  std::transform(records.begin(), records.end(), std::back_inserter(logs),
                 [&](const log::Record& record) { return examine(component, record, sheet); });
  leaveFastLogsToEffects(logs);
  nameReversedSprings(logs);
  if (const std::vector<Scaled> scales = scalesOf(logs); !scales.empty()) {
    nameCommonScale(scales, sheet);
    nameOddScales(scales, sheet);
  }
  if (auto turned = withContactsTurned(elements)) {
    std::for_each(logs.begin(), logs.end(), [&](Examined& log) { nameTurnedContact(*turned, log); });
  }
  std::vector<RigFinding> findings;
  for (const Examined& log : logs) {
    if (log.suspicion) {
      findings.push_back(log.suspicion->finding);
    }
  }
  return findings;
}

}  // namespace rubber_suspension::measurement
