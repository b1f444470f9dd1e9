// Errors of a rig: their columns in the least-squares system, their fit, and the findings.
#include "rubber_suspension/measurement/rig_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "measurement/statistics.h"
#include "numerics/difference_quotient.h"
#include "numerics/gram.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::measurement {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kShift = 0.01;  // share of the range, for the derivative with respect to the displacement offset
// Ratio of successive relaxation times of the initial state. A sum of such exponentials approximates any other to 2 %.
constexpr double kRelaxationRatio = 4.0;
// Longest relaxation time as a share of the log. A slower force is a drift of unknown origin.
constexpr double kSlowestRelaxation = 0.25;
constexpr double kChance = 1e-3;  // probability of a false finding, per value and log
constexpr double kNormal95 = 1.96;
// RMS over the log in units of the noise. A smaller error increases the gap by less than 0.5 % of the noise.
constexpr double kMatters = 0.1;

struct Column {
  Nuisance nuisance;
  VectorXd values;
};

void addDelays(const VectorXd& simulated, double dt, std::vector<Column>& columns) {
  const VectorXd rate = -numerics::slopesOf(simulated) / dt;
  const auto middle = 0.5 * static_cast<double>(simulated.size() - 1);
  const VectorXd time = VectorXd::LinSpaced(simulated.size(), -middle, middle) * dt;
  columns.push_back({Nuisance::delay, rate});
  columns.push_back({Nuisance::clock, rate.cwiseProduct(time)});
}

void addInitialState(Index count, std::vector<Column>& columns) {
  const double slowest = kSlowestRelaxation * static_cast<double>(count);
  for (double time = 1.0; time < slowest; time *= kRelaxationRatio) {
    columns.push_back({Nuisance::initial_state,
                       (VectorXd::LinSpaced(count, 0.0, static_cast<double>(count - 1)) / -time).array().exp()});
  }
}

// Returns the signal at time t - delay - clock (t - middle of the log), by cubic interpolation.
VectorXd delayed(const VectorXd& values, double delay, double clock) {
  if (delay == 0.0 && clock == 0.0) {
    return values;
  }
  const Index count = values.size();
  const double middle = 0.5 * static_cast<double>(count - 1);
  VectorXd result(count);
  for (Index i = 0; i < count; ++i) {
    const auto place = static_cast<double>(i);
    const double at = place - delay - clock * (place - middle);
    const Index left = std::clamp(static_cast<Index>(std::floor(at)), Index{1}, count - 3);
    const double s = std::clamp(at - static_cast<double>(left), -1.0, 2.0);
    result[i] = -s * (s - 1.0) * (s - 2.0) / 6.0 * values[left - 1] +
                (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0 * values[left] -
                (s + 1.0) * s * (s - 2.0) / 2.0 * values[left + 1] + (s + 1.0) * s * (s - 1.0) / 6.0 * values[left + 2];
  }
  return result;
}

// Returns the displacement of a record, less the displacement offset of its point of linearisation if there is one.
VectorXd displacementOf(const std::vector<gap::PreparedRecord>& records, const std::vector<RigPoint>& points,
                        std::size_t log) {
  return records[log].displacement.array() - (points.empty() ? 0.0 : points[log].displacement_zero);
}

// Possible motions of the rig before the log, each of which causes another initial force.
enum class Before {
  same_motion,  // first quarter of the log, point-mirrored, so that displacement and speed are continuous
  from_above,   // down from the highest displacement
  from_below,   // up from the lowest displacement
  from_rest,    // from the component's rest at 0
};
constexpr Before kMotionsBefore[] = {Before::same_motion, Before::from_above, Before::from_below, Before::from_rest};

// Returns true if this motion may have occurred before the log and have changed the state of the component, because the
// log begins in motion or displaced.
bool mayPrecede(Before kind, const log::Record& record) {
  constexpr double kDisplaced = 0.05;  // share of the range, more than an offset that nobody removed
  const bool displaced = record.lead_in.displacement.empty() &&
                         std::abs(record.displacement[0]) > kDisplaced * rangeOf(record.displacement);
  return kind == Before::from_rest ? displaced : startsInMotion(record);
}

// Returns the displacement from which the component moves to the start of the log.
double farthest(Before kind, const VectorXd& displacement) {
  switch (kind) {
    case Before::from_above:
      return displacement.maxCoeff();
    case Before::from_below:
      return displacement.minCoeff();
    default:
      return 0.0;
  }
}

VectorXd withMotionBefore(const VectorXd& displacement, Before kind) {
  const Index before = displacement.size() / 4;
  VectorXd result(before + displacement.size());
  const double far = farthest(kind, displacement);
  for (Index i = 0; i < before; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(before);
    result[i] = kind == Before::same_motion ? 2.0 * displacement[0] - displacement[before - i]
                                            : far + (displacement[0] - far) * share;
  }
  result.tail(displacement.size()) = displacement;
  return result;
}

RigColumns assemble(std::vector<Column> columns, const std::function<double(Nuisance)>& prior) {
  columns.erase(std::remove_if(columns.begin(), columns.end(),
                               [&](const Column& c) { return !(prior(c.nuisance) > 0.0) || c.values.norm() == 0.0; }),
                columns.end());
  RigColumns rig;
  rig.columns.resize(columns.empty() ? 0 : columns.front().values.size(), static_cast<Index>(columns.size()));
  rig.priors.resize(static_cast<Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto j = static_cast<Index>(i);
    rig.nuisances.push_back(columns[i].nuisance);
    rig.columns.col(j) = columns[i].values;
    rig.priors[j] = prior(columns[i].nuisance);
  }
  return rig;
}

// Least-squares solution in units of the priors, so that the normal matrix is well scaled.
struct Solution {
  VectorXd values;
  MatrixXd covariance;
};

Solution solveWithPriors(const MatrixXd& gram, const VectorXd& moment, const VectorXd& priors) {
  const Index size = priors.size();
  const MatrixXd scaled = priors.asDiagonal() * gram * priors.asDiagonal() + MatrixXd::Identity(size, size);
  const numerics::Cholesky factor(scaled);
  return {priors.asDiagonal() * factor.solve(VectorXd(priors.asDiagonal() * moment)),
          priors.asDiagonal() * factor.solve(MatrixXd(MatrixXd::Identity(size, size))) * priors.asDiagonal()};
}

Index columnOf(const RigColumns& rig, Nuisance nuisance) {
  const auto found = std::find(rig.nuisances.begin(), rig.nuisances.end(), nuisance);
  return found == rig.nuisances.end() ? -1 : static_cast<Index>(found - rig.nuisances.begin());
}

// Sets the base so that the values are total values instead of increments from the point of linearisation.
void setBase(const VectorXd& force, const RigPoint& point, RigColumns& rig) {
  rig.base = force;
  const auto subtract = [&](Nuisance nuisance, double value) {
    const Index i = columnOf(rig, nuisance);
    if (i >= 0) {
      rig.base -= value * rig.columns.col(i);
    }
  };
  subtract(Nuisance::displacement_zero, point.displacement_zero);
  subtract(Nuisance::delay, point.delay);
  subtract(Nuisance::clock, point.clock);
}

RigPoint pointOf(const RigFit& fit) {
  const auto value = [&](Nuisance nuisance) {
    const Index i = fit.column(nuisance);
    return i >= 0 ? fit.values[i] : 0.0;
  };
  return {value(Nuisance::displacement_zero), value(Nuisance::delay), value(Nuisance::clock)};
}

// Normal equations of whitened columns, with the weights of the last round.
struct NormalEquations {
  MatrixXd gram;
  VectorXd moment;
};

NormalEquations robustEquations(const MatrixXd& columns, const VectorXd& residual, const VectorXd& priors) {
  constexpr int kRounds = 3;  // iterations; the weights for few outliers converge at once
  NormalEquations equations{numerics::gramOf(columns), columns.transpose() * residual};
  for (int round = 0; round < kRounds; ++round) {
    const VectorXd left = residual - columns * solveWithPriors(equations.gram, equations.moment, priors).values;
    const VectorXd weights = huberWeights(left);
    const MatrixXd weighted = weights.asDiagonal() * columns;
    equations = {numerics::productOf(weighted, columns), weighted.transpose() * residual};
  }
  return equations;
}

Solution withoutColumn(const NormalEquations& equations, const VectorXd& priors, Index dropped) {
  VectorXd tight = priors;
  tight[dropped] *= 1e-9;
  return solveWithPriors(equations.gram, equations.moment, tight);
}

// Name and unit of an error in findings, and its tolerance, which may be relative to a quantity of the record.
struct NuisanceInfo {
  const char* finding;
  const char* unit;
  io::RigTolerance io::RigTolerances::* tolerance;
  double (*whole)(const log::Record&);
};

double rangeOfForce(const log::Record& record) { return rangeOf(record.force); }
double rangeOfDisplacement(const log::Record& record) { return rangeOf(record.displacement); }
double samplingInterval(const log::Record& record) { return record.dt; }
double itself(const log::Record&) { return 1.0; }

const NuisanceInfo& infoOf(Nuisance nuisance) {
  using Tolerances = io::RigTolerances;
  static constexpr NuisanceInfo kTable[] = {
      {finding::kForceZero, "N", &Tolerances::force_zero, rangeOfForce},
      {finding::kDisplacementZero, "m", &Tolerances::displacement_zero, rangeOfDisplacement},
      {finding::kDelay, "s", &Tolerances::delay, samplingInterval},
      {finding::kClock, "1", &Tolerances::clock, itself},
      {finding::kSensorGain, "1", &Tolerances::gain, itself},
      {finding::kRunningStart, "N", &Tolerances::initial_state, rangeOfForce},
  };
  return kTable[static_cast<std::size_t>(nuisance)];
}

std::string sentence(Nuisance nuisance, double value) {
  switch (nuisance) {
    case Nuisance::force_zero:
      return fmt::format(
          "the recorded force is too high by {:.3g} N: this is corrected; zero the load cell before the log", value);
    case Nuisance::displacement_zero:
      return fmt::format(
          "the recorded displacement is too high by {:.3g} m: this is corrected; zero the transducer before the log",
          value);
    case Nuisance::delay:
      return fmt::format(
          "the force is recorded {:.3g} s {} the displacement: this is corrected; use the same filter for both",
          std::abs(value), value > 0.0 ? "behind" : "ahead of");
    case Nuisance::clock:
      return fmt::format(
          "the clocks of force and displacement differ by {:.3g} ppm: this is corrected; record both channels on one "
          "clock",
          value * 1e6);
    case Nuisance::gain:
      return fmt::format("the recorded force is {:.3g} % {}: this is corrected; calibrate the force's channel",
                         std::abs(value) * 100.0, value > 0.0 ? "too large" : "too small");
    default:
      return fmt::format(
          "the log starts in motion: a relaxing force of {:.3g} N remains from the motion before it and is corrected; "
          "start the log at rest",
          value);
  }
}

RigFinding told(const std::string& log, Nuisance nuisance, double value, double deviation, double prior) {
  RigFinding result;
  result.log = log;
  result.finding = infoOf(nuisance).finding;
  result.value = value;
  result.interval_95 = {value - kNormal95 * deviation, value + kNormal95 * deviation};
  result.unit = infoOf(nuisance).unit;
  result.beyond_tolerance = std::abs(value) > io::kTolerated * prior;
  result.text = sentence(nuisance, value);
  return result;
}

// Returns true if values differ significantly from 0, that is, their chi-square exceeds the quantile.
bool significant(const VectorXd& values, const MatrixXd& covariance) {
  const double square = values.dot(numerics::Cholesky(covariance).solve(values));
  const boost::math::chi_squared distribution(static_cast<double>(values.size()));
  return square > boost::math::quantile(boost::math::complement(distribution, kChance));
}

bool significantAt(const RigFit& fit, const std::vector<Index>& columns) {
  return significant(fit.values(columns), fit.covariance(columns, columns));
}

// Returns true if the RMS of errors over the whole log, or over the duration of a start in motion, is worth reporting.
bool matters(const RigFit& fit, const std::vector<Index>& columns) {
  VectorXd part = VectorXd::Zero(fit.residual.size());
  bool start = false;
  for (const Index i : columns) {
    part += fit.values[i] * fit.rig.columns.col(i);
    start = start || fit.rig.nuisances[static_cast<std::size_t>(i)] == Nuisance::initial_state;
  }
  const double peak = part.cwiseAbs().maxCoeff();
  const double lasting = start && peak > 0.0 ? part.cwiseAbs().sum() / peak : static_cast<double>(part.size());
  return part.norm() > kMatters * fit.noise.deviation * std::sqrt(lasting);
}

std::vector<Index> columnsOf(const RigFit& fit, Nuisance nuisance) {
  std::vector<Index> columns;
  for (std::size_t i = 0; i < fit.rig.nuisances.size(); ++i) {
    if (fit.rig.nuisances[i] == nuisance) {
      columns.push_back(static_cast<Index>(i));
    }
  }
  return columns;
}

// Returns the finding on the initial state: its force at the first sample of the log.
RigFinding initialStateFinding(const std::string& name, const RigFit& fit, const std::vector<Index>& columns,
                               double prior) {
  double value = 0.0;
  double variance = 0.0;
  for (const Index i : columns) {
    value += fit.rig.columns(0, i) * fit.values[i];
    for (const Index j : columns) {
      variance += fit.rig.columns(0, i) * fit.covariance(i, j) * fit.rig.columns(0, j);
    }
  }
  return told(name, Nuisance::initial_state, value, std::sqrt(variance), prior);
}

// Returns the number of samples until the displacement has moved by `distance` for the first time.
double timeToMove(const VectorXd& displacement, double distance) {
  for (Index i = 1; i < displacement.size(); ++i) {
    if (std::abs(displacement[i] - displacement[0]) >= distance) {
      return static_cast<double>(i);
    }
  }
  return static_cast<double>(displacement.size());
}

// Returns true for a start at 0 without force, which no earlier motion has affected.
bool startsAtRest(const log::Record& record) {
  constexpr double kNear = 0.01;  // share of the range
  return std::abs(record.displacement[0]) < kNear * rangeOf(record.displacement) && record.force.size() > 0 &&
         std::abs(record.force[0]) < kNear * rangeOf(record.force);
}

// Returns the limit of the initial state [N]: how much the first forces differ from forces simulated from rest.
double mostLeft(const log::Record& record, const VectorXd& base) {
  constexpr Index kFirst = 5;  // samples, to average noise
  const Index count = std::min(kFirst, record.size());
  return std::abs((record.force - base).head(count).mean());
}

}  // namespace

Index RigFit::column(Nuisance nuisance) const { return columnOf(rig, nuisance); }

bool startsInMotion(const log::Record& record) {
  if (startsAtRest(record)) {
    return false;
  }
  // The time for ten times the distance is 10 times as long at constant speed, 3.2 times from a turning point, and at
  // most about 2.2 times after a standstill or if the amplitude is faded in.
  constexpr double kFadedIn = 2.6;
  const double range = rangeOf(record.displacement);
  const double noise = record.passed_frequency > 0.0 ? 0.0 : record.displacement_noise;
  const double near = std::min(std::max(0.01 * range, 6.0 * noise), 0.05 * range);
  return timeToMove(record.displacement, 10.0 * near) > kFadedIn * timeToMove(record.displacement, near);
}

RigModel::RigModel(std::vector<gap::PreparedRecord> records, std::vector<Mask> masks,
                   const io::RigTolerances& tolerances)
    : records_(std::move(records)), masks_(std::move(masks)), tolerances_(tolerances) {
  if (!masks_.empty() && masks_.size() != records_.size()) {
    throw std::invalid_argument(
        fmt::format("there are {} masks for {} records; accepted: one mask for each record, or none", masks_.size(),
                    records_.size()));
  }
  masks_.resize(records_.size());
  for (std::size_t i = 0; i < records_.size(); ++i) {
    if (masks_[i].size() == 0) {
      masks_[i] = Mask::Constant(records_[i].size(), true);
    }
    if (masks_[i].size() != records_[i].size()) {
      throw std::invalid_argument(fmt::format("{}: the mask has {} samples, the log has {}; accepted: equal numbers",
                                              records_[i].name, masks_[i].size(), records_[i].size()));
    }
  }
}

double RigModel::tolerance(Nuisance nuisance, const log::Record& record) const {
  const NuisanceInfo& info = infoOf(nuisance);
  return (tolerances_.*info.tolerance).of(info.whole(record));
}

double RigModel::prior(Nuisance nuisance, const gap::PreparedRecord& record) const {
  constexpr double kAnyZero = 100.0;  // multiple of the range of the force
  constexpr double kAnyGain = 1.0;
  if (nuisance == Nuisance::gain && record.own.gain) {
    return kAnyGain;
  }
  return nuisance == Nuisance::force_zero && record.own.zero ? kAnyZero * rangeOf(record.force)
                                                             : tolerance(nuisance, record);
}

std::vector<VectorXd> RigModel::simulateShifted(const Simulate& simulate, const std::vector<RigPoint>& points,
                                                double shift) const {
  std::vector<VectorXd> displacements;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    displacements.emplace_back(displacementOf(records_, points, i).array() + shift * rangeOf(records_[i].displacement));
  }
  return simulate(displacements);
}

std::vector<std::vector<VectorXd>> RigModel::simulateRunning(const Simulate& simulate,
                                                             const std::vector<RigPoint>& points) const {
  std::vector<std::vector<VectorXd>> forces;
  for (const Before kind : kMotionsBefore) {
    std::vector<VectorXd> displacements;
    bool any = false;
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const bool precedes = mayPrecede(kind, records_[i]);
      any = any || precedes;
      const VectorXd displacement = displacementOf(records_, points, i);
      displacements.push_back(precedes ? withMotionBefore(displacement, kind) : displacement);
    }
    forces.push_back(any ? simulate(displacements) : std::vector<VectorXd>());
  }
  return forces;
}

std::vector<RigColumns> RigModel::columns(const std::vector<VectorXd>& simulated, const Simulate& simulate,
                                          const std::vector<RigPoint>& points) const {
  std::vector<VectorXd> shifted;
  std::vector<std::vector<VectorXd>> running;
  if (simulate) {
    shifted = simulateShifted(simulate, points, kShift);
    running = simulateRunning(simulate, points);
  }
  std::vector<RigColumns> result;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const RigPoint point = points.empty() ? RigPoint() : points[i];
    const gap::PreparedRecord& record = records_[i];
    const auto late = [&](const VectorXd& force) { return delayed(force, point.delay / record.dt, point.clock); };
    const VectorXd base = late(simulated[i]);
    std::vector<Column> columns = {{Nuisance::force_zero, VectorXd::Ones(record.size())}};
    if (!shifted.empty()) {
      // If the recorded displacement is too high, the simulated force is too large.
      columns.push_back(
          {Nuisance::displacement_zero, (base - late(shifted[i])) / (kShift * rangeOf(record.displacement))});
    }
    addDelays(base, record.dt, columns);
    columns.push_back({Nuisance::gain, base});
    if (startsInMotion(record)) {
      addInitialState(record.size(), columns);
    }
    const double state = std::min(prior(Nuisance::initial_state, record), mostLeft(record, base));
    const double scale = std::max(state, 1e-300);
    for (std::size_t kind = 0; kind < running.size(); ++kind) {
      if (mayPrecede(kMotionsBefore[kind], record)) {
        columns.push_back({Nuisance::initial_state, (running[kind][i].tail(record.size()) - simulated[i]) / scale});
      }
    }
    result.push_back(assemble(std::move(columns), [&](Nuisance nuisance) {
      return nuisance == Nuisance::initial_state ? state : prior(nuisance, record);
    }));
    setBase(base, point, result.back());
  }
  return result;
}

RigFit RigModel::fit(std::size_t log, const RigColumns& columns, int iterations) const {
  const log::Record& record = records_[log];
  const Mask& mask = masks_[log];
  const VectorXd residual = record.force - columns.base;
  RigFit fit;
  fit.rig = columns;
  fit.values = VectorXd::Zero(columns.priors.size());
  // The first solution assumes white noise of the residual's size, so that the noise is then estimated from a residual
  // without offsets and trends.
  const VectorXd counted = mask.cast<double>();
  const double scale = std::max(gap::standardDeviation(residual), 1e-12 * rangeOf(record.force));
  const MatrixXd masked = counted.asDiagonal() * columns.columns / scale;
  NormalEquations equations{numerics::gramOf(masked), masked.transpose() * residual / scale};
  Solution solution = solveWithPriors(equations.gram, equations.moment, columns.priors);
  for (int i = 0; i < iterations; ++i) {
    fit.noise = estimateNoise(residual - columns.columns * solution.values, mask);
    const Whitener whitener(fit.noise, mask);
    equations = robustEquations(whitener(columns.columns), whitener(residual).col(0), columns.priors);
    solution = solveWithPriors(equations.gram, equations.moment, columns.priors);
  }
  fit.values = solution.values;
  fit.covariance = solution.covariance;
  fit.correction = columns.columns * fit.values;
  fit.residual = residual - fit.correction;
  const Index force = fit.column(Nuisance::force_zero);
  const Index displacement = fit.column(Nuisance::displacement_zero);
  if (force >= 0 && displacement >= 0) {
    const Solution alone = withoutColumn(equations, columns.priors, displacement);
    fit.zeros_as_force = alone.values[force];
    fit.zeros_as_force_deviation = std::sqrt(alone.covariance(force, force));
  }
  return fit;
}

std::vector<RigFit> RigModel::fitAll(const std::vector<VectorXd>& simulated, const Simulate& simulate) const {
  const std::vector<RigColumns> first = columns(simulated, simulate);
  std::vector<RigPoint> points;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    points.push_back(pointOf(fit(i, first[i], 1)));
  }
  const std::vector<VectorXd> about = simulate ? simulateShifted(simulate, points, 0.0) : simulated;
  const std::vector<RigColumns> second = columns(about, simulate, points);
  std::vector<RigFit> fits;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    fits.push_back(fit(i, second[i]));
    fits.back().correction = records_[i].force - simulated[i] - fits.back().residual;
  }
  return fits;
}

std::vector<RigFinding> RigModel::findings(std::size_t log, const RigFit& fit) const {
  const std::string& name = records_[log].name;
  std::vector<RigFinding> found;
  bool zero_found = false;
  for (const Nuisance nuisance :
       {Nuisance::force_zero, Nuisance::displacement_zero, Nuisance::delay, Nuisance::clock, Nuisance::gain}) {
    const Index i = fit.column(nuisance);
    if (i >= 0 && significantAt(fit, {i}) && matters(fit, {i})) {
      zero_found = zero_found || nuisance == Nuisance::force_zero || nuisance == Nuisance::displacement_zero;
      found.push_back(
          told(name, nuisance, fit.values[i], std::sqrt(fit.covariance(i, i)), tolerance(nuisance, records_[log])));
    }
  }
  const Index force = fit.column(Nuisance::force_zero);
  const Index displacement = fit.column(Nuisance::displacement_zero);
  if (!zero_found && force >= 0 && displacement >= 0 && significantAt(fit, {force, displacement}) &&
      matters(fit, {force, displacement})) {
    RigFinding zeros = told(name, Nuisance::force_zero, fit.zeros_as_force, fit.zeros_as_force_deviation,
                            tolerance(Nuisance::force_zero, records_[log]));
    zeros.text = fmt::format(
        "the offsets of force and displacement together are {:.3g} N too high; this log does not determine them "
        "separately; their sum is corrected; zero both before the log",
        fit.zeros_as_force);
    found.insert(found.begin(), zeros);
  }
  const std::vector<Index> initial = columnsOf(fit, Nuisance::initial_state);
  if (!initial.empty() && significantAt(fit, initial) && matters(fit, initial)) {
    found.push_back(initialStateFinding(name, fit, initial, tolerance(Nuisance::initial_state, records_[log])));
  }
  return found;
}

}  // namespace rubber_suspension::measurement
