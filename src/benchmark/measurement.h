// Pairs of runs in one process: a baseline and the library by turns. The ratio of a pair is free of what slows the
// whole machine.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::benchmark {

/// Seconds of the calling thread, so that other programs on the machine do not count, or of the wall.
enum class Clock { thread, wall };

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
  Clock clock = Clock::thread;
  int most_repetitions = 1000000;  ///< of a case that takes long
};

/// The same afterwards.
struct Result {
  std::string name;
  std::string baseline;
  std::string row;        ///< of the Markdown table
  io::Spread ratio;       ///< of the two times within a pair, over the pairs
  bool accurate = false;  ///< the error is within the tolerance
  bool slow = false;      ///< the ratio is beyond the largest accepted
};

/// Time of the clock [s].
double now(Clock clock);

/// Run the case once unmeasured, then in that many pairs; which of the two runs first alternates.
Result measure(const Case& work, int pairs);

/// Result rows as a Markdown table.
std::string markdown(const std::vector<Result>& results);

/// The ratio of library to baseline with its quartiles, one row per result.
io::Figure ratioFigure(const std::vector<Result>& results);

}  // namespace rubber_suspension::benchmark
