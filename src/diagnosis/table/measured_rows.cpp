// Prepares a table for the search: its excitation, its noise, and the candidates.
#include "diagnosis/table/measured_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <complex>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "diagnosis/effect.h"
#include "diagnosis/hypotheses/measured_logs.h"
#include "diagnosis/hypotheses/odds.h"
#include "diagnosis/hypotheses/shapes.h"
#include "element/each.h"
#include "fit/master_curve.h"
#include "numerics/least_squares.h"

namespace rubber_suspension::diagnosis::table {
namespace {

using Points = std::vector<fit::TablePoint>;

constexpr double kAssumed = 0.01;    // level of the noise relative to K* that laboratories state for bushings
constexpr double kMostRough = 0.03;  // largest level relative to K*; a rougher table may show an unlisted effect
constexpr int kFewestFree = 3;       // smallest number of complex degrees of freedom for an estimate
constexpr int kHighestDegree = 7;    // highest degree of a polynomial, which is enough for eight levels
constexpr double kMostUsed = 0.67;   // largest number of coefficients divided by the number of rows

// Sum of squared relative errors, and its number of complex degrees of freedom.
struct Rest {
  double squares = 0.0;
  int free = 0;
};

double upperEnd(const Rest& rest) {
  constexpr double kLower = 0.16;
  const double freedom = 2.0 * rest.free;  // real degrees of freedom
  const double quantile = boost::math::quantile(boost::math::chi_squared(freedom), kLower);
  return std::sqrt(rest.squares / rest.free * freedom / quantile);
}

// Rounds a value to a multiple of `unit`, so that nominally equal values are equal.
long long rounded(double value, double unit) { return std::llround(value / unit); }

using Condition = std::tuple<long long, long long>;
using Place = std::tuple<long long, long long, Condition>;

// Returns the mean displacement, rounded to a tenth of the smallest amplitude, and the temperature, rounded to half a
// kelvin. Both are measured, so that nominally equal values differ.
Condition conditionOf(const Points& points, const fit::TablePoint& point) {
  const auto smaller = [](const fit::TablePoint& x, const fit::TablePoint& y) { return x.amplitude < y.amplitude; };
  const double length = 0.1 * std::min_element(points.begin(), points.end(), smaller)->amplitude;
  return {rounded(point.mean, length), rounded(point.temperature.value_or(0.0), 0.5)};
}

Place placeOf(const Points& points, const fit::TablePoint& point) {
  return {rounded(std::log(point.frequency), 1e-3), rounded(std::log(point.amplitude), 1e-3),
          conditionOf(points, point)};
}

Rest repeats(const Points& points) {
  std::map<Place, Points> places;
  for (const fit::TablePoint& point : points) {
    places[placeOf(points, point)].push_back(point);
  }
  Rest rest;
  for (const auto& [place, rows] : places) {
    std::complex<double> mean = 0.0;
    for (const fit::TablePoint& row : rows) {
      mean += row.complexStiffness() / static_cast<double>(rows.size());
    }
    for (const fit::TablePoint& row : rows) {
      rest.squares += std::norm(row.complexStiffness() / mean - 1.0);
    }
    rest.free += static_cast<int>(rows.size()) - 1;
  }
  return rest;
}

std::size_t levelsOf(const Points& points, double (*value)(const fit::TablePoint&)) {
  std::set<long long> levels;
  for (const fit::TablePoint& point : points) {
    levels.insert(rounded(std::log(value(point)), 1e-3));
  }
  return levels.size();
}

// Returns the residual of ln K* from a polynomial of these degrees in ln(frequency) and ln(amplitude).
Rest leftBy(const Points& points, int in_frequency, int in_amplitude) {
  const auto rows = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd basis(rows, (in_frequency + 1) * (in_amplitude + 1));
  Eigen::MatrixXd values(rows, 2);
  for (Eigen::Index r = 0; r < rows; ++r) {
    const fit::TablePoint& point = points[static_cast<std::size_t>(r)];
    const double x = std::log(point.frequency / points.front().frequency);
    const double y = std::log(point.amplitude / points.front().amplitude);
    for (int p = 0; p <= in_frequency; ++p) {
      for (int q = 0; q <= in_amplitude; ++q) {
        basis(r, p * (in_amplitude + 1) + q) = std::pow(x, p) * std::pow(y, q);
      }
    }
    values(r, 0) = std::log(point.stiffness / points.front().stiffness);
    values(r, 1) = point.loss_angle;
  }
  const numerics::Remainder left = numerics::remainder(basis, values);
  return {left.values.squaredNorm(), static_cast<int>(rows - left.rank)};
}

// Returns the residual of the polynomial with the least residual per degree of freedom, for rows of one condition.
Rest smoothRest(const Points& points) {
  const auto frequencies = static_cast<int>(levelsOf(points, [](const fit::TablePoint& p) { return p.frequency; }));
  const auto amplitudes = static_cast<int>(levelsOf(points, [](const fit::TablePoint& p) { return p.amplitude; }));
  Rest best;
  for (int p = 0; p <= std::min(kHighestDegree, frequencies - 1); ++p) {
    for (int q = 0; q <= std::min(kHighestDegree, amplitudes - 1); ++q) {
      if ((p + 1) * (q + 1) > kMostUsed * static_cast<double>(points.size())) {
        continue;
      }
      const Rest rest = leftBy(points, p, q);
      if (rest.free > 0 && (best.free == 0 || rest.squares * best.free < best.squares * rest.free)) {
        best = rest;
      }
    }
  }
  return best;
}

Rest smoothness(const Points& points) {
  std::map<Condition, Points> conditions;
  for (const fit::TablePoint& point : points) {
    conditions[conditionOf(points, point)].push_back(point);
  }
  Rest sum;
  for (const auto& [condition, rows] : conditions) {
    const Rest rest = smoothRest(rows);
    sum.squares += rest.squares;
    sum.free += rest.free;
  }
  return sum;
}

}  // namespace

std::vector<std::string> neverShownByTables() {
  std::vector<std::string> names;
  for (const auto why : {InSettledLoops::over_before, InSettledLoops::has_crept, InSettledLoops::no_part_of_loop}) {
    for (const Effect& effect : effects()) {
      if (effect.in_settled_loops == why) {
        names.push_back(effect.name);
      }
    }
  }
  return names;
}

MeasuredRows::MeasuredRows(const io::ComponentDescription& component, const std::vector<fit::TablePoint>& points,
                           Scatter scatter)
    : scatter_(std::move(scatter)),
      loops_(std::make_shared<const fit::TableLoops>(points)),
      model_(component, fit::Level::specification),
      fitter_(loops_, model_, hypotheses::errorScale().oneOfSheet()) {}

fit::Excitation MeasuredRows::excitation() const {
  fit::Excitation excitation = fit::summarise(*loops_->records());
  if (fit::hasTemperatures(loops_->points())) {
    try {
      const fit::MasterCurve curve = fit::masterCurve(loops_->points(), fit::middleTemperature(loops_->points()));
      excitation.activation_energy = curve.activationEnergy();
    } catch (const std::invalid_argument&) {  // without activation energy, because the rows do not determine the shifts
    }
  }
  return excitation;
}

std::vector<fit::Candidate> MeasuredRows::candidates(const fit::Excitation& excitation,
                                                     const hypotheses::FittedHypothesis& re_estimated,
                                                     int threads) const {
  std::vector<fit::Candidate> all = diagnosis::candidates(excitation);
  for (fit::Candidate& candidate : all) {
    if (effectNamed(candidate.effect).in_settled_loops != InSettledLoops::shown) {
      candidate.terms.clear();
      candidate.free_in_log = {};
    }
    // A loop about its mean has the same first harmonic for damping that grows towards one side and for a dashpot.
    candidate.terms.erase(std::remove_if(candidate.terms.begin(), candidate.terms.end(),
                                         [](const fit::BasisTerm& term) { return term.of_a_side; }),
                          candidate.terms.end());
  }
  hypotheses::settleShapes(fitter_, re_estimated, *loops_->records(), threads, all);
  fit::findUnitEffects(all, *loops_->records(), threads);
  return all;
}

double MeasuredRows::discretisationError(const hypotheses::FittedHypothesis& model) const {
  const auto elements = *fit::elementsOf(model_, model.hypothesis, model.fit.parameters);
  const auto smooth = hypotheses::withSmoothDashpots(elements);
  if (smooth.empty()) {
    return 0.0;
  }
  const auto lagging = loops_->stiffnessOf(elements);
  std::vector<fit::TablePoint> points = loops_->points();
  const auto exact = loops_->stiffnessOf(smooth);
  for (std::size_t r = 0; r < points.size(); ++r) {
    points[r].stiffness = std::abs(exact[r]);
    points[r].loss_angle = std::arg(exact[r]);
  }
  return fit::gapOfTable(points, lagging);
}

hypotheses::Noise MeasuredRows::estimateNoise(const hypotheses::FittedHypothesis& best,
                                              const hypotheses::Search& /*search*/) const {
  hypotheses::Noise noise;
  noise.floor = noise.floor_with_rig = std::min(scatter_.level, best.fit.held_out);
  noise.of_logs.assign(loops_->points().size(), noise.floor);
  noise.source = scatter_.source + (noise.floor < scatter_.level ? ", but at most the residual of the model" : "");
  return noise;
}

Scatter scatterOf(const Points& points, std::optional<double> stated) {
  if (stated) {
    return {*stated, "given by --uncertainty"};
  }
  if (const Rest rest = repeats(points); rest.free >= kFewestFree) {
    return {upperEnd(rest), "repeated rows of the table"};
  }
  if (const auto left = fit::leftBySuperposition(points); left && left->free >= kFewestFree) {
    return {std::min(upperEnd({left->squares, left->free}), kMostRough),
            fmt::format("the residual of a master curve through the table, at most {:g} %", 100.0 * kMostRough)};
  }
  if (const Rest rest = smoothness(points); rest.free >= kFewestFree) {
    return {std::min(upperEnd(rest), kMostRough),
            fmt::format("the residual of a smooth surface over frequency and amplitude, at most {:g} %",
                        100.0 * kMostRough)};
  }
  return {kAssumed,
          fmt::format("assumed ({:g} %), because the table has too few rows for an estimate", 100.0 * kAssumed)};
}

}  // namespace rubber_suspension::diagnosis::table
