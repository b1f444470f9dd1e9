// Rows in which explanations differ.
#include "diagnosis/table/next_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/experiment/explanation.h"
#include "diagnosis/experiment/next_experiment.h"
#include "diagnosis/report/text.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr int kSteps = 7;        // of frequency and of amplitude
constexpr double kBeyond = 2.0;  // times the largest and part of the smallest that was measured

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// True where the table has a row that differs by no more than a tenth in frequency and in amplitude.
bool isMeasured(const std::vector<fit::TablePoint>& points, double frequency, double amplitude) {
  constexpr double kNear = 0.1;
  return std::any_of(points.begin(), points.end(), [&](const fit::TablePoint& point) {
    return std::abs(std::log(point.frequency / frequency)) < kNear &&
           std::abs(std::log(point.amplitude / amplitude)) < kNear;
  });
}

// New rows over the range of a table, or beyond it. Stiffness and loss angle are those of no measurement.
std::vector<fit::TablePoint> menuOf(const std::vector<fit::TablePoint>& points, double beyond) {
  Range frequency;
  Range amplitude;
  for (const fit::TablePoint& point : points) {
    frequency.include(point.frequency);
    amplitude.include(point.amplitude);
  }
  const auto spaced = [&](const Range& range) {
    const double low = range.low / beyond;
    const double high = range.high * beyond;
    return high > low ? response::logSpaced(low, high, kSteps) : std::vector<double>{low};
  };
  std::vector<fit::TablePoint> menu;
  for (const double f : spaced(frequency)) {
    for (const double a : spaced(amplitude)) {
      if (!isMeasured(points, f, a)) {
        menu.push_back({f, a, points.front().stiffness, 0.0, points.front().mean, points.front().temperature});
      }
    }
  }
  return menu;
}

// A row, and by how much the rival nearest to the model judged differs there, relative.
struct Difference {
  fit::TablePoint row;
  std::size_t rival = 0;
  double size = 0.0;
};

Difference largestDifference(const std::vector<fit::TablePoint>& menu, const MeasuredRows& measured,
                             const std::vector<Explanation>& explanations) {
  const fit::TableLoops loops(menu);
  std::vector<std::vector<std::complex<double>>> stiffness;
  for (const Explanation& explanation : explanations) {
    const FittedHypothesis& fitted = *explanation.fitted;
    stiffness.push_back(
        loops.stiffnessOf(*fit::elementsOf(measured.model(), fitted.hypothesis, fitted.fit.parameters)));
  }
  Difference largest;
  for (std::size_t r = 0; r < menu.size(); ++r) {
    Difference nearest{menu[r], 0, std::numeric_limits<double>::infinity()};
    for (std::size_t e = 1; e < stiffness.size(); ++e) {
      const double size = std::abs(stiffness[e][r] - stiffness[0][r]) / std::abs(stiffness[0][r]);
      if (size < nearest.size) {
        nearest.rival = e;
        nearest.size = size;
      }
    }
    if (std::isfinite(nearest.size) && nearest.size > largest.size) {
      largest = nearest;
    }
  }
  return largest;
}

std::string recordALog() {
  std::vector<std::string> names;
  std::transform(neverShownByTables().begin(), neverShownByTables().end(), std::back_inserter(names), spoken);
  return "Record a log: it also shows " + enumerated(names) + ", which no table does.";
}

}  // namespace

std::string nextRow(const MeasuredRows& measured, const Workings& workings) {
  const Search& search = workings.search;
  if (workings.answer.verdict == Verdict::none) {
    return "None is needed for what a table can show. " + recordALog();
  }
  const std::vector<Explanation> explanations = explanationsOf(workings);
  if (explanations.size() < 2) {
    return recordALog();
  }
  const std::string names = nameOf(search, *explanations[0].fitted);
  for (const double beyond : {1.0, kBeyond}) {
    const std::vector<fit::TablePoint> menu = menuOf(measured.loops().points(), beyond);
    if (menu.size() < 2) {
      continue;
    }
    const Difference best = largestDifference(menu, measured, explanations);
    if (best.size >= kLeastFloors * search.noise) {
      return fmt::format(
          "Measure a row at {:.3g} Hz and {}{}: {} and {} differ there by {} of K*, {:.1f} times the noise floor.",
          best.row.frequency, quantity(best.row.amplitude, "m"), beyond > 1.0 ? ", beyond what the table covers" : "",
          names, nameOf(search, *explanations[best.rival].fitted), percent(best.size), best.size / search.noise);
    }
  }
  return fmt::format("No row up to twice the range of the table tells {} from {}. {}", names,
                     nameOf(search, *explanations[1].fitted), recordALog());
}

}  // namespace rubber_suspension::diagnosis
