// Time-temperature superposition by variable projection: the search varies the shifts, the series follows from them.
#include "fit/master_curve.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "element/each.h"
#include "element/refuse.h"
#include "element/shift_parts.h"
#include "fit/residual_covariance.h"
#include "numerics/bounded_least_squares.h"
#include "numerics/trust_region.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::fit {
namespace {

using Eigen::VectorXd;
using element::ElementDescription;

constexpr double kPerDecade = 2.0;  // elements per decade; they approximate a springpot to 2e-4
constexpr double kBeyond = 1.5;     // decades of elements beyond those of the rows
constexpr double kScan = 0.25;      // step between starts of the search, in decades from coldest to warmest rows
constexpr double kStep = 1e-4;      // step of difference quotients, in decades and logarithms
constexpr double kNear = 0.1;       // relative to the amplitude; benches control amplitudes more closely

std::shared_ptr<const element::TemperatureShift> shiftOf(const ElementDescription& law) {
  return std::get<std::shared_ptr<const element::TemperatureShift>>(element::makeElement(law));
}

// Returns the index of each value's level, ascending. Values of a level differ by less than `width` from its smallest.
std::vector<std::size_t> levelsOf(const std::vector<double>& values, double width) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<std::size_t> levels(values.size());
  std::size_t level = 0;
  double first = values[order.front()];
  for (const std::size_t row : order) {
    if (values[row] - first >= width) {
      first = values[row];
      ++level;
    }
    levels[row] = level;
  }
  return levels;
}

double inverseOf(double temperature) { return 1.0 / (temperature + element::kZeroCelsius); }

std::vector<double> temperaturesOf(const std::vector<TablePoint>& points) {
  return element::each(points, [](const TablePoint& point) {
    element::refuseIf(!point.temperature, "table: a row has no temperature; accepted: a temperature in every row");
    return *point.temperature;
  });
}

struct Decades {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Decades rangeOf(const VectorXd& values) { return {values.minCoeff(), values.maxCoeff()}; }

// Returns the break frequencies [log10 of Hz] of elements that are evenly spread over a range.
VectorXd ladder(Decades range, double per_decade) {
  const auto steps = static_cast<Eigen::Index>(std::ceil((range.high - range.low) * per_decade));
  return VectorXd::LinSpaced(steps + 1, range.low, range.high);
}

// Returns K* of a spring and of Maxwell elements of 1 N/m (columns) over |K*| of the rows: real, then imaginary parts.
Eigen::MatrixXd basisOf(const VectorXd& decades, const VectorXd& scale, const VectorXd& breaks) {
  const Eigen::Index rows = decades.size();
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(2 * rows, breaks.size() + 1);
  basis.col(0).head(rows).setOnes();
  for (Eigen::Index j = 0; j < breaks.size(); ++j) {
    const Eigen::ArrayXd ratio = Eigen::pow(10.0, decades.array() - breaks[j]);
    basis.col(j + 1).head(rows) = ratio.square() / (1.0 + ratio.square());
    basis.col(j + 1).tail(rows) = ratio / (1.0 + ratio.square());
  }
  basis.topRows(rows).array().colwise() /= scale.array();
  basis.bottomRows(rows).array().colwise() /= scale.array();
  return basis;
}

// Returns the nonnegative stiffnesses that fit best by least squares.
VectorXd stiffnessesOf(const Eigen::MatrixXd& basis, const VectorXd& measured) {
  return numerics::nonNegativeLeastSquares(basis.transpose() * basis, basis.transpose() * measured,
                                           std::vector<bool>(static_cast<std::size_t>(basis.cols()), false));
}

// Rows of one amplitude and mean displacement.
struct Group {
  std::vector<Eigen::Index> rows;
  VectorXd frequencies;  // log10 of the frequency in Hz
  VectorXd scale;        // |K*| [N/m]
  VectorXd measured;     // K*/|K*|: real parts, then imaginary parts

  Group(const std::vector<TablePoint>& points, std::vector<Eigen::Index> of) : rows(std::move(of)) {
    const auto size = static_cast<Eigen::Index>(rows.size());
    frequencies.resize(size);
    scale.resize(size);
    measured.resize(2 * size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const TablePoint& point = points[static_cast<std::size_t>(rows[static_cast<std::size_t>(i)])];
      frequencies[i] = std::log10(point.frequency);
      scale[i] = point.stiffness;
      measured[i] = std::cos(point.loss_angle);
      measured[size + i] = std::sin(point.loss_angle);
    }
  }
};

std::vector<Group> groupsOf(const std::vector<TablePoint>& points) {
  const auto amplitudes = element::each(points, [](const TablePoint& point) { return std::log(point.amplitude); });
  const double smallest = std::exp(*std::min_element(amplitudes.begin(), amplitudes.end()));
  const auto by_amplitude = levelsOf(amplitudes, kNear);
  const auto by_mean = levelsOf(element::each(points, &TablePoint::mean), kNear * smallest);
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Eigen::Index>> rows;
  for (std::size_t r = 0; r < points.size(); ++r) {
    rows[{by_amplitude[r], by_mean[r]}].push_back(static_cast<Eigen::Index>(r));
  }
  return element::each(rows, [&](const auto& group) { return Group(points, group.second); });
}

// log10 a_T (shift of frequency) and ln b_T (shift of stiffness) of each row.
using Moves = Eigen::MatrixX2d;

// Returns the shifts of the rows as a function of a few parameters. Throws std::invalid_argument if no shifts exist.
using Shifting = std::function<Moves(const VectorXd& unknowns)>;

struct Shifted {
  VectorXd unknowns;
  VectorXd deviations;
  Moves moves;
  double misfit = 0.0;       // RMS misfit of the rows
  double information = 0.0;  // Bayesian information criterion
  bool inside = true;        // true if no parameter is at its limit
};

class Superposition {
 public:
  Superposition(const std::vector<TablePoint>& points, double reference)
      : reference_(reference), temperatures_(temperaturesOf(points)), groups_(groupsOf(points)) {
    frequencies_.resize(static_cast<Eigen::Index>(points.size()));
    for (std::size_t r = 0; r < points.size(); ++r) {
      frequencies_[static_cast<Eigen::Index>(r)] = std::log10(points[r].frequency);
    }
    level_of_ = levelsOf(temperatures_, kLeastTemperatureRange);
    levels_.resize(1 + *std::max_element(level_of_.begin(), level_of_.end()));
    for (std::size_t r = 0; r < points.size(); ++r) {
      Level& level = levels_[level_of_[r]];
      level.temperature += temperatures_[r];
      ++level.rows;
      level.frequencies.include(frequencies_[static_cast<Eigen::Index>(r)]);
    }
    for (Level& level : levels_) {
      level.temperature /= static_cast<double>(level.rows);
    }
  }

  SuperpositionRest leftByShifts() const {
    const Shifted free = byThemselves(byArrhenius().moves, true);
    const Decades range = rangeAt(free.moves);
    auto taken = static_cast<double>(free.unknowns.size());
    for (const Group& group : groups_) {
      const Eigen::MatrixXd basis = basisAt(group, free.moves, range);
      taken += static_cast<double>((stiffnessesOf(basis, group.measured).array() > 0.0).count());
    }
    const auto rows = static_cast<double>(frequencies_.size());
    return {free.misfit * free.misfit * rows, static_cast<int>(rows - 0.5 * taken)};
  }

  MasterCurve run() const {
    const Shifted arrhenius = byArrhenius();
    const Shifted free = byThemselves(arrhenius.moves, false);
    const std::optional<Shifted> wlf = byWlf(energyOf(arrhenius.unknowns[0]));
    MasterCurve curve;
    const Shifted* best = &arrhenius;
    if (wlf && wlf->inside && wlf->information < arrhenius.information) {
      best = &*wlf;
      curve.law = wlfLaw(wlf->unknowns);
      curve.constants = {{"c1", std::exp(wlf->unknowns[0]), wlf->deviations[0]},
                         {"c2", std::exp(wlf->unknowns[1]), wlf->deviations[1]}};
    } else {
      const double energy = energyOf(arrhenius.unknowns[0]);
      curve.law = arrheniusLaw(energy);
      curve.constants = {{"activation_energy", energy, arrhenius.deviations[0] / arrhenius.unknowns[0]}};
    }
    curve.misfit = best->misfit;
    curve.misfit_of_shifts = free.misfit;
    addShifts(free, curve);
    return curve;
  }

 private:
  struct Level {
    double temperature = 0.0;  // mean of its rows [degC]
    std::size_t rows = 0;
    Decades frequencies;
  };

  // Returns the activation energy [J/mol] for a shift by `decades` between the coldest and the warmest rows.
  double energyOf(double decades) const {
    return decades * std::log(10.0) * element::kGasConstant /
           (inverseOf(levels_.front().temperature) - inverseOf(levels_.back().temperature));
  }

  ElementDescription arrheniusLaw(double energy) const {
    return {"arrhenius_shift", {{"activation_energy", {energy}}, {"reference", {reference_}}}};
  }

  ElementDescription wlfLaw(const VectorXd& logarithms) const {
    return {"wlf_shift",
            {{"c1", {std::exp(logarithms[0])}}, {"c2", {std::exp(logarithms[1])}}, {"reference", {reference_}}}};
  }

  Moves movesBy(const ElementDescription& law) const {
    const auto shift = shiftOf(law);
    const element::Range range = shift->temperatures();
    Moves moves = Moves::Zero(frequencies_.size(), 2);
    for (std::size_t r = 0; r < temperatures_.size(); ++r) {
      element::refuseIf(!range.contains(temperatures_[r]), "{}: {:g} degC", law.type, temperatures_[r]);
      moves(static_cast<Eigen::Index>(r), 0) = std::log10(shift->at(temperatures_[r]).time);
    }
    return moves;
  }

  // Returns the largest Arrhenius shift, in decades from coldest to warmest, with which frequencies of neighbouring
  // temperatures overlap. Beyond this shift the curves do not meet, so that any shift fits.
  double largestShift() const {
    const double whole = inverseOf(levels_.front().temperature) - inverseOf(levels_.back().temperature);
    double largest = std::numeric_limits<double>::infinity();
    for (std::size_t l = 0; l + 1 < levels_.size(); ++l) {
      const double overlap = levels_[l + 1].frequencies.high - levels_[l].frequencies.low;
      const double part = inverseOf(levels_[l].temperature) - inverseOf(levels_[l + 1].temperature);
      largest = std::min(largest, overlap * whole / part);
    }
    return largest;
  }

  Eigen::MatrixXd basisAt(const Group& group, const Moves& moves, Decades range) const {
    const VectorXd reduced = group.frequencies + moves.col(0)(group.rows);
    const VectorXd scale = group.scale.array() * (-moves.col(1)(group.rows)).array().exp();
    return basisOf(reduced, scale, ladder(range, kPerDecade));
  }

  VectorXd residuals(const Moves& moves, Decades range) const {
    VectorXd all(2 * frequencies_.size());
    Eigen::Index next = 0;
    for (const Group& group : groups_) {
      const Eigen::MatrixXd basis = basisAt(group, moves, range);
      all.segment(next, basis.rows()) = basis * stiffnessesOf(basis, group.measured) - group.measured;
      next += basis.rows();
    }
    return all;
  }

  Decades rangeAt(const Moves& moves) const {
    const Decades rows = rangeOf(frequencies_ + moves.col(0));
    return {rows.low - kBeyond, rows.high + kBeyond};
  }

  // Returns the variance of sums of residuals relative to white residuals, with a first-order autoregression for
  // neighbours in frequency at one temperature.
  double correlationOf(const VectorXd& residual) const {
    double products = 0.0;
    Eigen::Index first = 0;
    for (const Group& group : groups_) {
      const auto size = static_cast<Eigen::Index>(group.rows.size());
      std::vector<Eigen::Index> order(group.rows.size());
      std::iota(order.begin(), order.end(), Eigen::Index{0});
      const auto key = [&](Eigen::Index i) {
        return std::pair(level_of_[static_cast<std::size_t>(group.rows[static_cast<std::size_t>(i)])],
                         group.frequencies[i]);
      };
      std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return key(a) < key(b); });
      for (std::size_t i = 0; i + 1 < order.size(); ++i) {
        if (key(order[i]).first == key(order[i + 1]).first) {
          for (const Eigen::Index part : {first, first + size}) {
            products += residual[part + order[i]] * residual[part + order[i + 1]];
          }
        }
      }
      first += 2 * size;
    }
    constexpr double kMost = 0.9;  // a sweep of about ten rows cannot determine more
    const double correlation = std::clamp(products / residual.squaredNorm(), 0.0, kMost);
    return (1.0 + correlation) / (1.0 - correlation);
  }

  Shifted search(const Shifting& shifting, const VectorXd& start, const numerics::Limits& limits) const {
    const Decades range = rangeAt(shifting(start));
    const auto of = [&](const VectorXd& unknowns) { return residuals(shifting(unknowns), range); };
    numerics::DifferencedSquares squares(of, kStep);
    Shifted result;
    result.unknowns = numerics::searchLeast(squares, start, limits).search;
    result.moves = shifting(result.unknowns);
    const VectorXd residual = of(result.unknowns);
    const double correlation = correlationOf(residual);
    const auto count = static_cast<double>(residual.size());
    const auto unknowns = static_cast<double>(start.size());
    const Covariance covariance = covarianceOf(squares.jacobian(result.unknowns), residual.squaredNorm(), correlation);
    result.deviations.resize(start.size());
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      result.deviations[i] = covariance.standardDeviation(i);
      const double to_limit = std::min(result.unknowns[i] - limits.lower[i], limits.upper[i] - result.unknowns[i]);
      result.inside = result.inside && to_limit > kStep;
    }
    result.misfit = std::sqrt(2.0 * residual.squaredNorm() / count);
    const double independent = std::max(2.0, count / correlation);
    result.information = independent * std::log(residual.squaredNorm()) + unknowns * std::log(independent);
    return result;
  }

  Shifted byArrhenius() const {
    const Shifting shifting = [this](const VectorXd& x) { return movesBy(arrheniusLaw(energyOf(x[0]))); };
    const double largest = std::min(largestShift(), element::kMostDecades);
    element::refuseIf(
        !(largest > kScan),
        "table: the curves of neighbouring temperatures do not overlap, so that their shift is undetermined; accepted: "
        "several frequencies at each temperature, in ranges that overlap between neighbouring temperatures");
    double best = std::numeric_limits<double>::infinity();
    VectorXd start(1);
    for (double decades = kScan; decades <= largest; decades += kScan) {
      const Moves shifts = shifting(VectorXd::Constant(1, decades));
      const double left = residuals(shifts, rangeAt(shifts)).squaredNorm();
      if (left < best) {
        best = left;
        start[0] = decades;
      }
    }
    return search(shifting, start, {VectorXd::Constant(1, kStep), VectorXd::Constant(1, largest)});
  }

  std::optional<Shifted> byWlf(double energy) const {
    constexpr double kSlowest = 0.1;  // lower limit of C_1 in the law of Williams, Landel and Ferry
    constexpr double kMost1 = 100.0;  // upper limit of C_1 in the element
    constexpr double kMost2 = 1000.0;
    const double below = std::max(0.0, reference_ - levels_.front().temperature);
    const double absolute = reference_ + element::kZeroCelsius;
    // At the reference temperature d log10 a_T/dT is -C_1/C_2, the constants of Williams, Landel and Ferry.
    const double slope = energy / (std::log(10.0) * element::kGasConstant * absolute * absolute);
    const numerics::Limits limits{Eigen::Vector2d(std::log(kSlowest), std::log(below + kLeastTemperatureRange)),
                                  Eigen::Vector2d(std::log(kMost1), std::log(kMost2))};
    std::optional<Shifted> best;
    for (const double c2 : {50.0, 100.0, 200.0}) {
      const VectorXd start = limits.inside(Eigen::Vector2d(std::log(slope * (below + c2)), std::log(below + c2)));
      try {
        Shifted found = search([this](const VectorXd& x) { return movesBy(wlfLaw(x)); }, start, limits);
        if (!best || found.misfit < best->misfit) {
          best = std::move(found);
        }
      } catch (const std::invalid_argument&) {  // these constants do not extend to the coldest rows
      }
    }
    return best;
  }

  std::size_t middle() const {
    const auto nearer = [&](const Level& a, const Level& b) {
      return std::abs(a.temperature - reference_) < std::abs(b.temperature - reference_);
    };
    return static_cast<std::size_t>(std::min_element(levels_.begin(), levels_.end(), nearer) - levels_.begin());
  }

  // Shifts each temperature separately, except the middle one, which the law shifts. `vertically`: b_T is fitted, too.
  Shifted byThemselves(const Moves& by_law, bool vertically) const {
    constexpr double kFar = 1.5;   // limit in decades
    constexpr double kMost = 0.7;  // limit of ln b_T
    const auto levels = static_cast<Eigen::Index>(levels_.size());
    Moves of_levels = Moves::Zero(levels, 2);
    for (std::size_t r = 0; r < level_of_.size(); ++r) {
      of_levels(static_cast<Eigen::Index>(level_of_[r]), 0) +=
          by_law(static_cast<Eigen::Index>(r), 0) / static_cast<double>(levels_[level_of_[r]].rows);
    }
    std::vector<Eigen::Index> free;
    for (Eigen::Index l = 0; l < levels; ++l) {
      if (l != static_cast<Eigen::Index>(middle())) {
        free.push_back(l);
      }
    }
    const Shifting shifting = [=](const VectorXd& x) {
      Moves all = of_levels;
      all.col(0)(free) = x.head(levels - 1);
      if (vertically) {
        all.col(1)(free) = x.tail(levels - 1);
      }
      Moves moves(frequencies_.size(), 2);
      for (std::size_t r = 0; r < level_of_.size(); ++r) {
        moves.row(static_cast<Eigen::Index>(r)) = all.row(static_cast<Eigen::Index>(level_of_[r]));
      }
      return moves;
    };
    VectorXd start = VectorXd::Zero((vertically ? 2 : 1) * (levels - 1));
    VectorXd far = VectorXd::Constant(start.size(), kMost);
    start.head(levels - 1) = of_levels.col(0)(free);
    far.head(levels - 1).setConstant(kFar);
    return search(shifting, start, {start - far, start + far});
  }

  void addShifts(const Shifted& free, MasterCurve& curve) const {
    Eigen::Index next = 0;
    for (std::size_t l = 0; l < levels_.size(); ++l) {
      const auto row = std::find(level_of_.begin(), level_of_.end(), l) - level_of_.begin();
      curve.shifts.push_back(
          {levels_[l].temperature, free.moves(row, 0), l == middle() ? 0.0 : free.deviations[next++]});
    }
    // Found shifts are relative to the middle temperature, so the law's shift of that temperature is added.
    const double there = curve.shifts[middle()].decades;
    const double offset = curve.decadesAt(levels_[middle()].temperature) - there;
    for (FoundShift& shift : curve.shifts) {
      shift.decades += offset;
    }
  }

  double reference_;
  std::vector<double> temperatures_;  // temperature of each row
  std::vector<Group> groups_;
  VectorXd frequencies_;               // log10 of the frequency in Hz
  std::vector<std::size_t> level_of_;  // level of each row
  std::vector<Level> levels_;          // ordered from cold to warm
};

ElementDescription spring(double stiffness) { return {"spring", {{"stiffness", {stiffness}}}}; }

// Share of the stiffness that replaces 0, which elements reject. It is too small to affect a fit.
constexpr double kNothing = 1e-4;

std::vector<ElementDescription> prony(const std::vector<TablePoint>& points, const VectorXd& decades,
                                      const VectorXd& scale, const VectorXd& measured) {
  constexpr double kToEnds = 0.5;  // decades beyond the rows, so that an element lies on either side of each row
  const Decades range = rangeOf(decades);
  const VectorXd breaks = ladder({range.low - kToEnds, range.high + kToEnds}, 1.0);
  const VectorXd stiffnesses = stiffnessesOf(basisOf(decades, scale, breaks), measured);
  const double least = kNothing * points.front().stiffness;
  std::vector<ElementDescription> elements = {spring(std::max(stiffnesses[0], least))};
  for (Eigen::Index j = 0; j < breaks.size(); ++j) {
    if (stiffnesses[j + 1] > least) {
      elements.push_back(
          {"maxwell", {{"stiffness", {stiffnesses[j + 1]}}, {"break_frequency", {std::pow(10.0, breaks[j])}}}});
    }
  }
  return elements;
}

std::vector<ElementDescription> springAndSpringpot(const std::vector<TablePoint>& points, const VectorXd& decades,
                                                   const VectorXd& scale, const VectorXd& measured) {
  const Decades range = rangeOf(decades);
  const double middle = 0.5 * (range.low + range.high);
  double best = std::numeric_limits<double>::infinity();
  std::vector<ElementDescription> elements;
  for (double order = 0.05; order < 1.0; order += 0.05) {
    Eigen::MatrixXd basis = basisOf(decades, scale, VectorXd());
    basis.conservativeResize(Eigen::NoChange, 2);
    const VectorXd magnitude = Eigen::pow(10.0, order * (decades.array() - middle)) / scale.array();
    basis.col(1) << magnitude * std::cos(0.5 * element::kPi * order), magnitude * std::sin(0.5 * element::kPi * order);
    const VectorXd stiffnesses = stiffnessesOf(basis, measured);
    const double left = (basis * stiffnesses - measured).squaredNorm();
    if (left < best) {
      best = left;
      const double least = kNothing * points.front().stiffness;
      elements = {spring(std::max(stiffnesses[0], least)),
                  {"springpot",
                   {{"stiffness", {std::max(stiffnesses[1], least)}},
                    {"reference_frequency", {std::pow(10.0, middle)}},
                    {"order", {order}},
                    {"low_frequency", {std::pow(10.0, range.low)}},
                    {"high_frequency", {std::pow(10.0, range.high)}}}}};
    }
  }
  return elements;
}

}  // namespace

double MasterCurve::decadesAt(double temperature) const { return std::log10(shiftOf(law)->at(temperature).time); }

double MasterCurve::activationEnergy() const {
  const double low = shifts.front().temperature;
  const double high = shifts.back().temperature;
  return (decadesAt(low) - decadesAt(high)) * std::log(10.0) * element::kGasConstant /
         (inverseOf(low) - inverseOf(high));
}

bool hasTemperatures(const std::vector<TablePoint>& points) {
  Decades range;
  for (const TablePoint& point : points) {
    if (point.temperature) {
      range.include(*point.temperature);
    }
  }
  return range.high - range.low >= kLeastTemperatureRange;
}

MasterCurve masterCurve(const std::vector<TablePoint>& points, double reference) {
  checkPoints(points);
  return Superposition(points, reference).run();
}

std::optional<SuperpositionRest> leftBySuperposition(const std::vector<TablePoint>& points) {
  if (!hasTemperatures(points)) {
    return std::nullopt;
  }
  try {
    return Superposition(points, middleTemperature(points)).leftByShifts();
  } catch (const std::invalid_argument&) {  // the table does not determine the shifts
    return std::nullopt;
  }
}

double middleTemperature(const std::vector<TablePoint>& points) {
  const std::vector<double> temperatures = temperaturesOf(points);
  const auto [low, high] = std::minmax_element(temperatures.begin(), temperatures.end());
  return std::round(0.5 * (*low + *high));
}

std::vector<TablePoint> reducedBy(const ElementDescription& law, std::vector<TablePoint> points) {
  const auto shift = shiftOf(law);
  for (TablePoint& point : points) {
    if (point.temperature) {
      const element::Shift at = shift->at(*point.temperature);
      point.frequency *= at.time;
      point.stiffness /= at.force;
      point.temperature = law.value("reference");
    }
  }
  return points;
}

std::vector<ElementDescription> seriesOf(Series series, const std::vector<TablePoint>& points) {
  std::vector<Eigen::Index> rows(points.size());
  std::iota(rows.begin(), rows.end(), Eigen::Index{0});
  const Group all(points, rows);
  return (series == Series::prony ? prony : springAndSpringpot)(points, all.frequencies, all.scale, all.measured);
}

}  // namespace rubber_suspension::fit
