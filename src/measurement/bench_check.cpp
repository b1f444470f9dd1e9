// Finds errors of a bench that explain its logs better than the component, and reports the likeliest error of a log.
#include "rubber_suspension/measurement/bench_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "element/each.h"
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

constexpr double kPeakToPeak = 2.0;
constexpr double kFollows = 0.7;   // correlation of a force with one that explains it
constexpr double kClearly = 0.35;  // share of the variance that a better explanation adds
// Phase distance 1 - cos that counts as one nat, because measured phases scatter by 45 degrees about an explanation.
constexpr double kOneNat = 0.3;

// A factor between measured and configured stiffness (or its inverse), and the units whose confusion causes it.
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

// Returns the factor, at least 1, between two numbers of the same sign.
double apart(double one, double other) { return std::exp(std::abs(std::log(one / other))); }

// Returns true if the factor is larger than any effect causes.
bool isLarge(double factor) { return apart(factor, 1.0) > 90.0; }

bool isAboutTwo(double ratio) {
  constexpr double kExactly = 1.04;
  return apart(apart(ratio, 1.0), kPeakToPeak) < kExactly;
}

// Returns the factor between two units that is nearest to the ratio. The ratio may differ by `of_large` from a factor
// above 90, and by `of_small` from a smaller one. Returns nullopt if it differs more from all factors.
std::optional<UnitFactor> unitFactorOf(double ratio, double of_large, double of_small) {
  std::optional<UnitFactor> best;
  for (UnitFactor unit : kUnitFactors) {
    unit.factor = ratio > 1.0 ? unit.factor : 1.0 / unit.factor;
    const double off = apart(ratio, unit.factor);
    if (off < (isLarge(unit.factor) ? of_large : of_small) && (!best || off < apart(ratio, best->factor))) {
      best = unit;
    }
  }
  return best;
}

// For assumed units: a large factor may differ by as much as effects cause. A small factor may differ only by the
// tolerance of the data sheet and a little friction; otherwise it would explain the log of any other component.
std::optional<UnitFactor> assumedFactorOf(double ratio) { return unitFactorOf(ratio, 2.5, 1.25); }

// Tolerance of a data sheet: a stiffness may be wrong by the factor of 1.4 standard deviations without any effect.
struct Sheet {
  explicit Sheet(double tolerance) : factor(std::exp(1.4 * tolerance)) {}

  // Smallest and largest ratio of measured to configured stiffness due to effects and the data sheet. Friction raises
  // it 3 times at small amplitude, 1.5 times over all; progressive stiffness doubles it; other effects lower it to a
  // third.
  double least() const { return 0.345 / factor; }
  double most() const { return 3.04 * factor; }
  bool plausible(double ratio) const { return ratio > least() && ratio < most(); }
  bool mayBe(double ratio) const { return apart(ratio, 1.0) < factor; }

  // For named units, which are rarely wrong: a small factor may differ by the data sheet's tolerance, a large one by
  // half.
  std::optional<UnitFactor> namedFactorOf(double ratio) const {
    return unitFactorOf(ratio, std::max(1.5, factor), factor);
  }

  double factor;
};

const Sheet kUsualSheet(estimation::SheetTolerance::kUsual);

// Simulates from rest and without the transverse motion, which suffices to check orders of magnitude.
VectorXd simulate(gap::LogDriver& component, const VectorXd& displacement, const log::Record& record) {
  log::Record from_rest;
  from_rest.dt = record.dt;
  from_rest.temperature = record.temperature;
  return component.over(from_rest, displacement, gap::Before::nothing);
}

// The configured component. A contact, or any compliance of one side, deforms only under forces of one sign.
struct Configured {
  Configured(std::vector<element::ElementDescription> elements, double tolerance)
      : component(elements), sheet(tolerance) {
    for (element::ElementDescription& description : elements) {
      const element::ElementPointer element = element::makeElement(description);
      const auto* const series = std::get_if<std::shared_ptr<const element::SeriesElement>>(&element);
      const auto compliance = series != nullptr ? (*series)->compliance() : std::nullopt;
      if (compliance && (compliance->tension == 0.0) != (compliance->compression == 0.0)) {
        description.values["side"] = {-description.value("side")};
        contact = description.type;
      }
    }
    if (!contact.empty()) {
      turned.emplace(elements);
    }
  }

  gap::LogDriver component;
  Sheet sheet;
  std::string contact;                   // type of the last compliance of one side; empty if there is none
  std::optional<gap::LogDriver> turned;  // the component with its compliances of one side on the other side
};

// An effect with the same symptoms: a delay changes only the phase, a mass in fast motion lowers or reverses the
// stiffness.
enum class Likewise { nothing, delay, mass };

struct Explained {
  Explained(RigFinding named, Likewise other = Likewise::nothing, double votes = 1.0)
      : finding(std::move(named)), likewise(other), nats(other == Likewise::nothing ? 0.0 : votes) {}

  RigFinding finding;
  Likewise likewise;
  double nats;  // evidence for an error that all logs have
};

using Explanation = std::optional<Explained>;

struct Shown {
  Configured& configured;
  const log::Record& record;
  Explanation own = std::nullopt;  // likeliest explanation from this log alone
  VectorXd simulated = {};
  std::vector<Octave> octaves = {};
  std::vector<Octave> expected = {};  // spectrum of the simulated force
  Slope measured = {};
  Slope simulated_slope = {};
  double ratio = 0.0;
  double force_correlation = 0.0;  // correlation of measured and simulated force
  double force_ratio = 0.0;        // standard deviation of the measured force over that of the simulated force
  double period = 0.0;             // samples per typical cycle
  // Net work of the loops over the largest possible work: as recorded, and with the force shifted forward or backward
  // by a delay that channels may have.
  double work = 0.0;
  double work_forward = 0.0;
  double work_backward = 0.0;
  double work_deviation = 0.0;

  // Returns true if the displacement explains half of the variance of the force.
  bool isElastic() const { return measured.correlation * measured.correlation > 0.5; }
  bool falls() const { return isElastic() && measured.stiffness < 0.0 && simulated_slope.correlation > 0.0; }
  bool rises() const { return isElastic() && measured.stiffness > 0.0; }
  // Sampling may change the work of a loop by a hundredth of the largest possible work.
  double leastWork() const { return std::max(3.0 * work_deviation, 0.01); }
  bool givesEnergy() const { return work_forward < -leastWork(); }
  bool takesEnergy() const { return work_forward > leastWork() || work > std::max(3.0 * work_deviation, 1e-9); }

  // Returns the factor by which the measured force is too large if nothing else is wrong. Returns nullopt if no factor
  // is credible; for a damper, only factors above 90 are credible.
  std::optional<double> scale() const {
    if (isElastic()) {
      return simulated_slope.stiffness > 0.0 && measured.stiffness > 0.0 ? std::optional(ratio) : std::nullopt;
    }
    return force_correlation > 0.8 && isLarge(force_ratio) ? std::optional(force_ratio) : std::nullopt;
  }

  bool isScaled() const { return !own && scale() && record.units != log::UnitsAre::accepted; }

  // Returns the log-likelihood [nat] of the measured phases if `phase` maps the expected phases to them.
  template <class Phase>
  double nats(Phase phase) const {
    return -phaseDistance(octaves, expected, phase) / kOneNat;
  }
  double natsOfSign() const {
    return nats([](double phase, double) { return phase + element::kPi; });
  }
};

template <class... Values>
RigFinding fatal(const std::string& log, const char* finding, double value, const char* unit,
                 fmt::format_string<Values...> text, Values&&... values) {
  return {log, finding, value, {value, value}, unit, true, true, fmt::format(text, std::forward<Values>(values)...)};
}

// `remedy`: how the user can correct the unit; if empty, the text names options of the command line.
RigFinding unitFinding(const std::string& log, double ratio, const UnitFactor& unit, std::string remedy = "") {
  if (remedy.empty()) {
    remedy = fmt::format(
        "give the correct unit with an option such as --unit force=kN, or use --columns force={:.4g}*NAME or "
        "displacement={:.4g}*NAME",
        1.0 / unit.factor, unit.factor);
  }
  return fatal(log, finding::kUnitFactor, ratio, "1",
               "the measured stiffness is {:.3g} times the configured stiffness, close to the factor {:.4g} of a wrong "
               "unit ({}): {}; if the units are correct, use --accept-units",
               ratio, unit.factor, unit.units, remedy);
}

RigFinding componentFinding(const std::string& log, double ratio, const Sheet& sheet, const std::string& logs) {
  return fatal(log, finding::kOtherComponent, ratio, "1",
               "the measured stiffness is {:.3g} times the configured stiffness{}; tolerances and effects explain only "
               "factors from {:.2g} to {:.2g}, and no wrong unit has this factor: check that measurement and component "
               "file belong to the same component; if they do, use --accept-units",
               ratio, logs, sheet.least(), sheet.most());
}

RigFinding peakToPeakFinding(const std::string& log, double ratio, const std::string& remedy) {
  return fatal(
      log, finding::kPeakToPeak, ratio, "1",
      "the measured stiffness is {:.3g} times the configured stiffness in all motions, and nothing else differs: the "
      "{} is a peak-to-peak value, or {} components are clamped: {}; if the values are correct, use --accept-units",
      ratio, ratio > 1.0 ? "force" : "displacement", ratio > 1.0 ? "two parallel" : "two in series of", remedy);
}

RigFinding signFinding(const Shown& log) {
  return fatal(log.record.name, finding::kSign, -1.0, "1",
               "the force falls while the displacement rises (stiffness {:.3g} N/m, configured {:.3g} N/m), and the "
               "loops dissipate no energy ({:.2g} of the possible maximum), which excludes a mass in fast motion: the "
               "sign of one channel is reversed; multiply this channel by -1, for example with --columns force=-NAME{}",
               log.measured.stiffness, log.simulated_slope.stiffness, log.work,
               log.ratio >= 0.0 || log.configured.sheet.plausible(-log.ratio)
                   ? ""
                   : fmt::format("; besides, the measured stiffness is {:.3g} times the configured stiffness: check "
                                 "the units and the component file",
                                 -log.ratio));
}

RigFinding swapFinding(const Shown& log) {
  return fatal(
      log.record.name, finding::kSwappedColumns, log.ratio, "1",
      "force and displacement seem to be swapped (stiffness {:.3g} N/m, configured {:.3g} N/m; the loops create "
      "energy, loss {:.2g} of the possible maximum): swap the columns with --columns displacement=NAME force=NAME",
      log.measured.stiffness, log.simulated_slope.stiffness, log.work_forward);
}

// Returns true if a constant force may be the force of an open contact: no force is smaller, and all displacements with
// a larger force lie on one side of the displacements with this force.
bool isOfASlackContact(const log::Record& record, const DeadPart& dead) {
  const auto part = [&](const VectorXd& column) { return column.segment(dead.begin, dead.end - dead.begin).array(); };
  const double still = 0.01 * rangeOf(record.force);  // twice the range of a part that is at rest
  for (const double side : {1.0, -1.0}) {
    const Eigen::ArrayXd more = side * (record.force.array() - part(record.force).mean());
    const double nearest = (more > still).select(side * record.displacement.array(), HUGE_VAL).minCoeff();
    if (more.minCoeff() >= -still && (side * part(record.displacement)).maxCoeff() <= nearest) {
      return true;
    }
  }
  return false;
}

// Finds a channel that measured nothing in the log or in a part of it.
Explanation deadChannel(const Shown& log) {
  constexpr double kAsMuch = 0.5;   // share of the force's deviation in the rest of the log
  constexpr double kFarther = 0.8;  // share of the displacement's deviation; a smaller motion may be within a free play
  const log::Record& record = log.record;
  for (const bool is_force : {false, true}) {
    const VectorXd& channel = is_force ? record.force : record.raw_displacement;
    const VectorXd& other = is_force ? record.raw_displacement : record.force;
    const char* const name = is_force ? "force" : "displacement";
    const char* const unit = is_force ? "N" : "m";
    if (rangeOf(channel) <= 1e-12 * channel.cwiseAbs().maxCoeff()) {
      return fatal(record.name, finding::kConstant, channel[0], unit,
                   "the {} is constant at {:.4g} {}: check the channel's cable, and the choice of the column "
                   "(--columns {}=NAME)",
                   name, channel[0], unit, name);
    }
    const DeadPart dead = deadPart(channel, other, is_force ? kFarther : kAsMuch);
    if (dead.end > dead.begin && (is_force ? !isOfASlackContact(record, dead) : isOfAMotion(other, channel, dead))) {
      const double begin = static_cast<double>(dead.begin) * record.dt;
      const double end = static_cast<double>(dead.end) * record.dt;
      return fatal(record.name, finding::kConstant, static_cast<double>(dead.end - dead.begin) * record.dt, "s",
                   "the {} is constant from {:.4g} to {:.4g} s of {:.4g} s while the {} continues: check the channel's "
                   "cable, and remove this part of the log",
                   name, begin, end, record.duration(), is_force ? "displacement" : "force");
    }
  }
  return std::nullopt;
}

Explanation tooShort(const Shown& log) {
  constexpr Index kFewestMoving = 30;
  constexpr double kFewestPerCycle = 4.0;  // samples per cycle
  const log::Record& record = log.record;
  const Index count = record.size();
  const VectorXd step = (record.displacement.tail(count - 1) - record.displacement.head(count - 1)).cwiseAbs();
  const Index moving = (step.array() > 0.01 * rmsOf(step)).count();
  if (moving < kFewestMoving) {
    // A longer log does not help if the displacement rests after a step, as in relaxation or creep.
    const bool held = 2 * moving < count;
    return fatal(record.name, finding::kTooShort, static_cast<double>(moving), "1",
                 "{} samples in motion are too few; accepted: at least {}: {}", moving, kFewestMoving,
                 held ? fmt::format("the displacement is at rest in the other {}: record the motion at a higher rate, "
                                    "or add a log with more motion",
                                    count - moving)
                      : "record longer, or at a higher rate");
  }
  const double per_cycle = 2.0 * element::kPi / typicalPhase(record.displacement);
  if (per_cycle < kFewestPerCycle) {
    return fatal(record.name, finding::kTooShort, per_cycle, "1",
                 "{:.2g} samples per cycle are too few; accepted: at least {}: record at a higher rate", per_cycle,
                 kFewestPerCycle);
  }
  return std::nullopt;
}

// Finds a channel that follows the magnitude of the other channel rather than its signed value.
Explanation rectified(const Shown& log) {
  const double of_force = correlationOf(log.record.force, log.simulated.cwiseAbs());
  const VectorXd magnitude = (log.record.force.array() - log.record.force.mean()).abs();
  const double of_displacement = correlationOf(log.record.displacement, magnitude);
  const double as_recorded = std::max(std::pow(log.force_correlation, 2), std::pow(log.measured.correlation, 2));
  for (const auto& [name, correlation] : {std::pair("force", of_force), {"displacement", of_displacement}}) {
    if (correlation > kFollows && correlation * correlation > as_recorded + kClearly) {
      return fatal(log.record.name, finding::kRectified, correlation, "1",
                   "the {} has lost its sign: it follows the magnitude of the expected values (correlation {:.2f}; "
                   "with their sign {:.2f}): record it without a rectifier",
                   name, correlation, log.force_correlation);
    }
  }
  return std::nullopt;
}

// Finds a force that is small noise and follows neither the displacement nor, like friction, the direction of motion.
Explanation silent(const Shown& log) {
  constexpr double kNothing = 0.05;    // share of the simulated force
  constexpr double kUnrelated = 0.15;  // magnitude of a correlation
  const log::Record& record = log.record;
  const Index count = record.size();
  const Index lag = std::clamp<Index>(std::lround(log.period / 8.0), 1, count - 1);
  const VectorXd way = record.displacement.tail(count - lag) - record.displacement.head(count - lag);
  const VectorXd force = record.force.tail(way.size());
  const auto isRelated = [](double correlation) { return std::abs(correlation) > kUnrelated; };
  if (log.force_ratio > kNothing || record.units == log::UnitsAre::accepted || isRelated(log.force_correlation) ||
      isRelated(correlationOf(record.displacement, record.force)) || isRelated(correlationOf(way, force)) ||
      isRelated(correlationOf(way.cwiseSign(), force))) {
    return std::nullopt;
  }
  return fatal(record.name, finding::kConstant, log.force_ratio, "1",
               "the force does not respond to the displacement, but only scatters by {:.3g} N, {:.2g} % of the "
               "component's force: check the clamps and the channel's cable",
               record.force_deviation, 100.0 * log.force_ratio);
}

// Returns the ratio of length to force unit (in SI) with which the log fits the component after columns are exchanged.
std::optional<double> unitsOfSwap(gap::LogDriver& component, const log::Record& record, const Sheet& sheet) {
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

// Returns true if exchanged columns fit the component in any units, and the loops do not contradict this.
bool looksSwapped(const Shown& log) {
  return log.work_forward <= 3.0 * log.work_deviation &&
         unitsOfSwap(log.configured.component, log.record, log.configured.sheet);
}

// Returns true if the phases fit a mass better than a reversed sign. The mass reverses the stiffness at the log's mean
// frequency, but not in slow motion; its prior is one nat.
bool isTurnedAsByMass(const Shown& log) {
  std::vector<Octave> with_mass = log.expected;
  for (Octave& octave : with_mass) {
    const double times = octave.frequency / (log.record.mean_frequency * log.record.dt);
    octave.cross -= (log.simulated_slope.stiffness - log.measured.stiffness) * times * times * octave.power;
  }
  const double mass = phaseDistance(log.octaves, with_mass, [](double phase, double) { return phase; });
  return -mass / kOneNat + 1.0 > log.natsOfSign();
}

// Finds a force that falls where the displacement rises, with loops that create energy for any delay of the channels.
// The work is inconclusive for a spring with hardly any loss. Its force then has to be the simulated force with the
// opposite sign, but may have any size, because the configured stiffness may be a guess or have a wrong unit.
Explanation reversedSign(const Shown& log) {
  const bool gives = log.work_backward < -log.leastWork();
  if (!log.falls() || (!gives && (log.takesEnergy() || log.force_correlation > -0.9))) {
    return std::nullopt;
  }
  return Explained(signFinding(log), isTurnedAsByMass(log) ? Likewise::mass : Likewise::nothing, gives ? 1.0 : 0.0);
}

// Finds exchanged columns from the stiffness. A wrong unit of the same factor is preferred unless the loops create
// energy.
Explanation exchangedSizes(const Shown& log) {
  const bool ask = log.rises() && log.simulated_slope.stiffness > 0.0 && !log.configured.sheet.plausible(log.ratio) &&
                   (!assumedFactorOf(log.ratio) || log.givesEnergy());
  return ask && looksSwapped(log) ? Explanation(swapFinding(log)) : std::nullopt;
}

// Finds a wrong unit if units are assumed. A mass may also make the stiffness too low, by less than a factor of ten.
Explanation assumedUnit(const Shown& log) {
  const auto scale = log.scale();
  const bool ask = log.record.units == log::UnitsAre::assumed && scale && !log.configured.sheet.plausible(*scale);
  const auto unit = ask ? assumedFactorOf(*scale) : std::nullopt;
  const bool soft = log.ratio > 0.1 && log.ratio < 1.0;
  if (!unit) {
    return std::nullopt;
  }
  return Explained(unitFinding(log.record.name, *scale, *unit), soft ? Likewise::mass : Likewise::nothing);
}

// Returns the likeliest delay of the force [samples] and its log-likelihood [nat], less one nat for the free parameter.
// The delay, of either sign, is from `least_share` to three quarters of a typical period.
std::pair<double, double> bestDelay(const Shown& log, double least_share) {
  std::pair<double, double> best = {0.0, -HUGE_VAL};
  for (int i = -30; i <= 30; ++i) {
    const double delay = 0.025 * i * log.period;
    const double nats =
        log.nats([&](double phase, double frequency) { return phase - 2.0 * element::kPi * frequency * delay; });
    best = std::abs(0.025 * i) >= least_share && nats - 1.0 > best.second ? std::make_pair(delay, nats - 1.0) : best;
  }
  return best;
}

// Explains loops that create energy at a plausible stiffness by a reversed sign, exchanged columns or a delay,
// whichever is likeliest given the measured phases.
Explanation turnedPhases(const Shown& log) {
  if (log.falls() || !log.givesEnergy() || (log.scale() && !log.configured.sheet.plausible(*log.scale()))) {
    return std::nullopt;
  }
  // Friction or damping far exceeds the configured values, so that the expected phases do not apply. Only a reversed
  // sign makes friction or damping create energy.
  if (!log.isElastic() && !log.configured.sheet.plausible(log.force_ratio)) {
    return signFinding(log);
  }
  // If the stiffness is as configured and exchanged columns do not fit, only a delay remains as explanation, however
  // short. Delays within the range of the effect time_delay are not reported here.
  constexpr double kMostBehind = 15.0;     // samples; the longer of this and the next limit applies
  constexpr double kLongestBehind = 0.03;  // [s]
  constexpr double kMostAhead = 4.0;       // limit of a leading force [samples]
  constexpr double kClearlyLate = 0.124;   // share of a period; a longer delay competes with sign and columns
  const bool as_stiff = log.isElastic() && log.configured.sheet.plausible(log.ratio);
  const bool only_delay = as_stiff && !looksSwapped(log);
  const auto [delay, late] = bestDelay(log, only_delay ? 0.0 : kClearlyLate);
  if (only_delay && delay <= std::max(kMostBehind, kLongestBehind / log.record.dt) && delay >= -kMostAhead) {
    return std::nullopt;
  }
  const double sign = log.natsOfSign();
  const double swap = log.nats([](double phase, double) { return -phase; });
  if (only_delay || late > std::max(sign, swap)) {
    return Explained{
        fatal(log.record.name, finding::kDelay, delay * log.record.dt, "s",
              "the loops create energy, because the force is {:.3g} s {} the displacement, {:.2g} of a cycle: "
              "synchronise the two channels",
              std::abs(delay * log.record.dt), delay > 0.0 ? "behind" : "ahead of", std::abs(delay) / log.period),
        Likewise::delay};
  }
  return Explained{sign > swap ? signFinding(log) : swapFinding(log), as_stiff ? Likewise::delay : Likewise::nothing};
}

// Finds a force that fits the component with its contact on the other side. This is checked first, because the
// configured contact is open where the log has a force.
Explanation turnedContact(const Shown& log) {
  if (!log.configured.turned) {
    return std::nullopt;
  }
  const log::Record& record = log.record;
  const double as_configured =
      std::max(0.0, correlationOf(record.force, simulate(log.configured.component, record.displacement, record)));
  const double as_turned = correlationOf(record.force, simulate(*log.configured.turned, record.displacement, record));
  if (as_turned <= kFollows || as_turned * as_turned <= as_configured * as_configured + kClearly) {
    return std::nullopt;
  }
  return fatal(
      record.name, finding::kContactSide, as_turned, "1",
      "the contact `{}` of the component is open while this log has a force; with `side` reversed the force matches "
      "(correlation {:.2f}, as configured {:.2f}): reverse `side`, or the signs of both displacement and force",
      log.configured.contact, as_turned, as_configured);
}

// Compares a log with the component. Both channels have to vary.
void compare(Shown& log) {
  constexpr double kForward = 1.5;        // samples; a smaller delay between channels is no fault of a bench
  constexpr double kLargestShare = 0.02;  // share of a cycle
  const log::Record& record = log.record;
  log.measured = slopeOf(record.displacement, record.force);
  log.simulated_slope = slopeOf(record.displacement, log.simulated);
  log.ratio = log.simulated_slope.stiffness != 0.0 ? log.measured.stiffness / log.simulated_slope.stiffness : 0.0;
  log.force_correlation = correlationOf(record.force, log.simulated);
  const double simulated = gap::standardDeviation(log.simulated);
  log.force_ratio = simulated > 0.0 ? gap::standardDeviation(record.force) / simulated : 0.0;
  log.period = 2.0 * element::kPi / typicalPhase(record.displacement);
  const CrossSpectrum spectrum(record.displacement, record.force);
  const double forward = log.measured.stiffness < 0.0 ? std::min(kForward, kLargestShare * log.period) : kForward;
  log.work = spectrum.work(0.0).first;
  log.work_backward = spectrum.work(-forward).first;
  std::tie(log.work_forward, log.work_deviation) = spectrum.work(forward);
  log.octaves = spectrum.octaves();
  log.expected = CrossSpectrum(record.displacement, log.simulated).octaves();
}

// Returns the first explanation that is found.
Explanation firstOf(std::initializer_list<Explanation (*)(const Shown&)> explanations, const Shown& log) {
  for (const auto& explain : explanations) {
    if (Explanation found = explain(log)) {
      return found;
    }
  }
  return std::nullopt;
}

// A fault of a channel excludes all other explanations. Exchanged columns are checked before units and phases, because
// they also make the loops create energy.
Shown shownBy(const log::Record& record, Configured& configured) {
  Shown log{configured, record};
  log.own = firstOf({turnedContact, deadChannel, tooShort}, log);
  if (log.own) {
    return log;
  }
  log.simulated = simulate(configured.component, record.displacement, record);
  if (log.simulated.allFinite()) {
    compare(log);
    log.own = firstOf({rectified, silent, reversedSign, exchangedSizes, assumedUnit, turnedPhases}, log);
  }
  return log;
}

// Evidence of all logs of a bench.
struct Bench {
  explicit Bench(const std::vector<Shown>& logs) {
    for (const Shown& log : logs) {
      const bool right = log.own ? log.own->nats == 0.0 && log.rises() : !log.falls();
      nats += log.own && !right ? log.own->nats : -1.0;
      fastest_right = right ? std::max(fastest_right, log.record.mean_frequency) : fastest_right;
      if (log.isScaled()) {
        scaled.push_back(&log);
      }
    }
  }

  double nats = 0.0;                 // evidence for an error that all logs have [nat]
  double fastest_right = 0.0;        // highest mean frequency of a log with the right sign [Hz]
  std::vector<const Shown*> scaled;  // logs whose scale is judged
};

double medianScale(const std::vector<const Shown*>& logs) {
  return medianOf(element::each(logs, [](const Shown* log) { return *log->scale(); }));
}

// Finds one factor in all logs whose force is otherwise similar to the simulated one; or, in one log, a factor above
// 90, which no effect causes, if other logs are plausible.
std::optional<RigFinding> scaleOf(const Shown& log, const std::vector<const Shown*>& logs) {
  constexpr double kOne = 1.5;         // largest factor between two logs due to their frequency and amplitude
  constexpr double kLike = 0.8;        // least correlation with the simulated force
  constexpr double kJustLike = 0.995;  // least correlation for a factor that a wrong data sheet may also cause
  const Sheet& sheet = log.configured.sheet;
  const std::string& name = log.record.name;
  const double scale = *log.scale();
  const double common = medianScale(logs);
  const auto isOfAll = [&](double likeness, const auto& holds) {
    return std::all_of(logs.begin(), logs.end(), [&](const Shown* other) {
      return holds(*other->scale()) && apart(*other->scale(), common) < kOne && other->force_correlation > likeness;
    });
  };
  if (isOfAll(kLike, [&](double other) { return !sheet.plausible(other); })) {
    const auto unit = sheet.namedFactorOf(common);
    const std::string all = logs.size() == 1 ? "" : fmt::format(", equally in all {} logs", logs.size());
    return unit ? unitFinding(name, scale, *unit) : componentFinding(name, scale, sheet, all);
  }
  if (!sheet.mayBe(kPeakToPeak) && isOfAll(kJustLike, isAboutTwo) && isAboutTwo(common)) {
    return peakToPeakFinding(name, scale,
                             fmt::format("--columns {}=0.5*NAME", common > 1.0 ? "force" : "displacement"));
  }
  const auto right = element::those(logs, [&](const Shown* other) { return sheet.plausible(*other->scale()); });
  const auto unit = right.empty() ? std::nullopt : kUsualSheet.namedFactorOf(scale / medianScale(right));
  return unit && isLarge(unit->factor) ? std::optional(unitFinding(name, scale, *unit)) : std::nullopt;
}

// Returns the likeliest explanation of a log given all logs; nullopt if an effect explains the log equally well. A
// reversed sign, exchanged columns or a wrong unit affect all logs of a bench. So each log that shows such an error
// counts as one nat for it, each right log as one nat against it, and a reversed spring without loss as nothing. A mass
// reverses or softens only the fastest logs.
std::optional<RigFinding> explanationOf(const Shown& log, const Bench& bench) {
  if (log.own) {
    const bool effect = log.own->likewise == Likewise::delay ||
                        (log.own->likewise == Likewise::mass && log.record.mean_frequency > bench.fastest_right);
    return effect && bench.nats < 0.0 ? std::nullopt : std::optional(log.own->finding);
  }
  return log.isScaled() ? scaleOf(log, bench.scaled) : std::nullopt;
}

// Shifts the force forward by some samples, and removes the samples at the ends that then have no partner.
void bringForward(Index samples, log::Record& record) {
  const Index count = record.size() - std::abs(samples);
  record.force = VectorXd(record.force.segment(std::max<Index>(samples, 0), count));
  for (VectorXd* channel : {&record.displacement, &record.raw_displacement, &record.temperature, &record.across}) {
    if (channel->size() > 0) {
      *channel = VectorXd(channel->segment(std::max<Index>(-samples, 0), count));
    }
  }
}

}  // namespace

std::optional<BenchCorrection> correctionOf(const RigFinding& finding,
                                            const std::vector<element::ElementDescription>& elements,
                                            const log::Record& record) {
  log::Record corrected = record;
  if (finding.finding == finding::kSign) {
    corrected.force *= -1.0;
    return BenchCorrection{"force times -1", corrected};
  }
  if (finding.finding == finding::kUnitFactor || finding.finding == finding::kPeakToPeak) {
    const double of_unit = unitFactorOf(finding.value, HUGE_VAL, HUGE_VAL)->factor;  // the nearest of all
    const double of_peaks = finding.value > 1.0 ? kPeakToPeak : 1.0 / kPeakToPeak;
    const double factor = finding.finding == finding::kUnitFactor ? of_unit : of_peaks;
    corrected.force /= factor;
    return BenchCorrection{fmt::format("force divided by {:.4g}", factor), corrected};
  }
  const auto samples = static_cast<Index>(std::lround(finding.value / record.dt));
  if (finding.finding == finding::kDelay && finding.fatal && 2 * std::abs(samples) <= record.size()) {
    bringForward(samples, corrected);
    return BenchCorrection{fmt::format("force brought forward by {:.3g} s", finding.value), corrected};
  }
  gap::LogDriver component(elements);
  const auto units =
      finding.finding == finding::kSwappedColumns ? unitsOfSwap(component, record, kUsualSheet) : std::nullopt;
  if (!units) {
    return std::nullopt;
  }
  corrected.displacement = corrected.raw_displacement = *units * record.force;
  corrected.force = record.raw_displacement / *units;
  return BenchCorrection{"columns exchanged", corrected};
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
    return fatal(table, finding::kSign, -1.0, "1",
                 "all loss angles are negative, which would create energy: the phase has the opposite sign convention, "
                 "or force and displacement are swapped: correct the table");
  }
  const Sheet sheet(tolerance);
  const auto size = [](const std::complex<double>& stiffness) { return std::abs(stiffness); };
  const double ratio = medianOf(element::each(measured, size)) / medianOf(element::each(configured, size));
  const auto isTwo = [](const auto& one, const auto& other) { return isAboutTwo(std::abs(one) / std::abs(other)); };
  if (!sheet.mayBe(kPeakToPeak) && isAboutTwo(ratio) &&
      std::equal(measured.begin(), measured.end(), configured.begin(), isTwo)) {
    return peakToPeakFinding(table, ratio, "halve the peak-to-peak values");
  }
  if (sheet.plausible(ratio)) {
    return std::nullopt;
  }
  const auto unit = assumedFactorOf(ratio);
  return unit ? unitFinding(table, ratio, *unit, "correct the unit in the header of the table")
              : componentFinding(table, ratio, sheet, "");
}

std::vector<RigFinding> checkBench(const std::vector<element::ElementDescription>& elements,
                                   const std::vector<log::Record>& records, double tolerance) {
  Configured configured(elements, tolerance);
  const auto logs = element::each(records, [&](const log::Record& record) { return shownBy(record, configured); });
  const Bench bench(logs);
  std::vector<RigFinding> findings;
  for (const Shown& log : logs) {
    if (auto told = explanationOf(log, bench)) {
      findings.push_back(std::move(*told));
    }
  }
  return findings;
}

}  // namespace rubber_suspension::measurement
