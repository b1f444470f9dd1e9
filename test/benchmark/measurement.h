// Alternating runs of a baseline and the library in one process. A slow computer changes both, so the ratio of a pair
// does not depend on it.
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
  std::string baseline;           ///< name of what the library is compared with
  std::string unit;               ///< unit of `count`: steps, estimations, ...
  double count = 1.0;             ///< units of work in one run of the library
  double baseline_count = 1.0;    ///< units of work in one run of the baseline
  std::function<void()> bare;     ///< one run of the baseline
  std::function<void()> library;  ///< one run of the library
  std::function<double()> error;  ///< relative error of the library's last run, compared with the baseline
  std::string error_meaning;      ///< what the error is
  double tolerance = 0.0;         ///< largest accepted error
  /// Largest accepted ratio. It is compared with the lower quartile over the pairs, which other programs do not raise.
  double most = std::numeric_limits<double>::infinity();
};

/// Returns the largest difference divided by the largest expected value.
double relativeDifference(const std::vector<double>& expected, const std::vector<double>& actual);

/// Returns a case whose library and baseline use the same bench. Each of their runs does `count` units of work.
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

/// Returns a case in which library and baseline store forces [N] in the bench's members `library` and `bare`. The
/// forces must agree, and each step is a unit of work.
template <class Bench, class Library, class Bare>
Case forceCase(const std::shared_ptr<Bench>& bench, const std::string& name, Library library,
               const std::string& baseline, Bare bare) {
  Case result = caseOf(bench, name, library, baseline, bare, "step", static_cast<double>(bench->library.size()));
  result.error = [bench] { return relativeDifference(bench->bare, bench->library); };
  result.error_meaning = "of the largest force";
  // Sums in another order differ by rounding errors in each step. Relaxation and friction forget them again.
  result.tolerance = 1e-11;
  return result;
}

/// A measured row of the table.
struct Result {
  std::string name;
  std::string baseline;
  std::string row;        ///< row of the Markdown table
  io::Spread ratio;       ///< time of the library divided by that of the baseline within a pair, over all pairs
  bool accurate = false;  ///< the error is within the tolerance
  bool slow = false;      ///< the ratio exceeds the largest accepted one
};

/// Runs the case once without measuring, and then in `pairs` pairs. Library and baseline take turns in running first.
Result measure(const Case& work, int pairs);

/// Returns the results as a Markdown table.
std::string markdown(const std::vector<Result>& results);

/// Returns a figure of the ratios of the library to the baseline, with quartiles and one row per result.
io::Figure ratioFigure(const std::vector<Result>& results);

}  // namespace rubber_suspension::benchmark
