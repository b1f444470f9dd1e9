// Alternating runs of a baseline and the library in one process. The ratio of a pair is independent of what slows down
// the whole machine.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/timing.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::benchmark {

/// One row of the table before it is measured.
struct Case {
  std::string name;
  std::string baseline;           ///< what the library is compared with
  std::string unit;               ///< what `count` counts: steps, estimations, ...
  double count = 1.0;             ///< units of work in one run of the library
  double baseline_count = 1.0;    ///< units of work in one run of the baseline
  std::function<void()> bare;     ///< one run of the baseline
  std::function<void()> library;  ///< one run of the library
  std::function<double()> error;  ///< relative error of the library's last run, compared with the baseline
  std::string error_meaning;      ///< what the error is
  double tolerance = 0.0;         ///< largest accepted error
  /// Largest accepted ratio, compared with the lower quartile over enough pairs, which a busy machine does not raise.
  double most = std::numeric_limits<double>::infinity();
};

/// Returns the largest difference, relative to the largest expected value.
double relativeDifference(const std::vector<double>& expected, const std::vector<double>& actual);

/// Returns a case whose two sides work on a bench; each of their runs does `count` units of work.
template <class Bench, class Library, class Bare>
Case caseOf(const std::shared_ptr<Bench>& bench, const std::string& name, Library library, const std::string& baseline,
            Bare bare, const std::string& unit, double count) {
  Case result;
  result.name = name;
  result.baseline = baseline;
  result.unit = unit;
  result.count = result.baseline_count = count;
  result.bare = [bench, bare]() mutable { std::invoke(bare, *bench); };
  result.library = [bench, library] { std::invoke(library, *bench); };
  return result;
}

/// Returns a case whose sides store forces [N] in the bench's members `library` and `bare`, which have to agree; each
/// step is a unit of work.
template <class Bench, class Library, class Bare>
Case forceCase(const std::shared_ptr<Bench>& bench, const std::string& name, Library library,
               const std::string& baseline, Bare bare) {
  Case result = caseOf(bench, name, library, baseline, bare, "step", static_cast<double>(bench->library.size()));
  result.error = [bench] { return relativeDifference(bench->bare, bench->library); };
  result.error_meaning = "of the largest force";
  // The order of summation differs by some roundings per step, whose effect relaxation and friction forget.
  result.tolerance = 1e-11;
  return result;
}

/// A measured row of the table.
struct Result {
  std::string name;
  std::string baseline;
  std::string row;        ///< of the Markdown table
  io::Spread ratio;       ///< library to baseline within a pair, over the pairs
  bool accurate = false;  ///< the error is within the tolerance
  bool slow = false;      ///< the ratio exceeds the largest accepted one
};

/// Runs the case once unmeasured, then in `pairs` pairs; the two sides alternate in running first.
Result measure(const Case& work, int pairs);

/// Returns the results as a Markdown table.
std::string markdown(const std::vector<Result>& results);

/// Returns a figure of the ratios of library to baseline with their quartiles, one row per result.
io::Figure ratioFigure(const std::vector<Result>& results);

}  // namespace rubber_suspension::benchmark
