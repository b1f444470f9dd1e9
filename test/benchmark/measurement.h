// Pairs of runs in one process: a baseline and the library by turns. The ratio of a pair is free of what slows the
// whole machine.
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
  std::string unit;               ///< what one of `count` is: step, estimation, ...
  double count = 1.0;             ///< units of work in one run of the library
  double baseline_count = 1.0;    ///< and in one run of the baseline
  std::function<void()> bare;     ///< one run of the baseline
  std::function<void()> library;  ///< one run of the library
  std::function<double()> error;  ///< of the library's last run against that of the baseline, relative
  std::string error_meaning;      ///< what the error is
  double tolerance = 0.0;         ///< the error may be as large
  /// The ratio may be as large: held by its lower quartile, which a busy machine does not raise, over enough pairs.
  double most = std::numeric_limits<double>::infinity();
};

/// Largest difference over the largest expected value.
double relativeDifference(const std::vector<double>& expected, const std::vector<double>& actual);

/// A row whose two sides work on a bench, of which each run does so many units of work.
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

/// One whose sides leave series of forces [N] in the bench's members `library` and `bare`, which have to be the same;
/// each step is one of them.
template <class Bench, class Library, class Bare>
Case forceCase(const std::shared_ptr<Bench>& bench, const std::string& name, Library library,
               const std::string& baseline, Bare bare) {
  Case result = caseOf(bench, name, library, baseline, bare, "step", static_cast<double>(bench->library.size()));
  result.error = [bench] { return relativeDifference(bench->bare, bench->library); };
  result.error_meaning = "of the largest force";
  // Both sum the same products in another order: some roundings per step, which relaxation and friction forget.
  result.tolerance = 1e-11;
  return result;
}

/// The same afterwards.
struct Result {
  std::string name;
  std::string baseline;
  std::string row;        ///< of the Markdown table
  io::Spread ratio;       ///< of the two times within a pair, over the pairs
  bool accurate = false;  ///< the error is within the tolerance
  bool slow = false;      ///< the ratio is beyond the largest accepted
};

/// Run the case once unmeasured, then in that many pairs; which of the two runs first alternates.
Result measure(const Case& work, int pairs);

/// Result rows as a Markdown table.
std::string markdown(const std::vector<Result>& results);

/// The ratio of library to baseline with its quartiles, one row per result.
io::Figure ratioFigure(const std::vector<Result>& results);

}  // namespace rubber_suspension::benchmark
