// Measures pairs of runs, computes medians, and makes a table and a figure.
#include "benchmark/measurement.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <boost/algorithm/string/erase.hpp>

namespace rubber_suspension::benchmark {
namespace {

std::string readableRatio(double ratio) {
  return fmt::format(ratio < 0.1 ? "{:.2g}" : ratio < 100.0 ? "{:.2f}" : "{:.0f}", ratio);
}

}  // namespace

double relativeDifference(const std::vector<double>& expected, const std::vector<double>& actual) {
  const Eigen::Map<const Eigen::ArrayXd> right(expected.data(), static_cast<Eigen::Index>(expected.size()));
  const Eigen::Map<const Eigen::ArrayXd> found(actual.data(), right.size());
  return (found - right).abs().maxCoeff<Eigen::PropagateNaN>() / right.abs().maxCoeff();
}

Result measure(const Case& work, int pairs) {
  work.bare();
  work.library();
  const double error = work.error();
  std::vector<double> bare;
  std::vector<double> library;
  std::vector<double> ratio;
  for (int i = 0; i < pairs; ++i) {
    const bool bare_first = i % 2 == 0;
    for (const bool is_bare : {bare_first, !bare_first}) {
      const double seconds = secondsOf(is_bare ? work.bare : work.library, Clock::thread);
      (is_bare ? bare : library).push_back(seconds / (is_bare ? work.baseline_count : work.count));
    }
    ratio.push_back(library.back() / bare.back());
  }
  Result result{work.name, work.baseline, "", spreadOf(ratio), error <= work.tolerance, false};  // false for NaN
  constexpr int kFewest = 15;  // pairs; with fewer, the benchmark only checks that the case runs
  result.slow = pairs >= kFewest && result.ratio.lower > work.most;
  result.row = fmt::format("| {} | {} | **{}** ({} to {}) | {} per {} | {} | {:.1e} {} |\n", work.name, work.baseline,
                           readableRatio(result.ratio.median), readableRatio(result.ratio.lower),
                           readableRatio(result.ratio.upper), readable(spreadOf(library).median), work.unit,
                           readable(spreadOf(bare).median), error, work.error_meaning);
  return result;
}

std::string markdown(const std::vector<Result>& results) {
  std::string text =
      "| work of the library | compared with | ratio (quartiles) | library | compared | error |\n"
      "|---|---|---|---|---|---|\n";
  for (const Result& result : results) {
    text += result.row;
  }
  return text;
}

io::Figure ratioFigure(const std::vector<Result>& results) {
  io::Axes axes{"", "time of the library / time of the other [-]", "", true};
  std::vector<io::Spread> ratios;
  for (const Result& result : results) {
    // The table marks code with backticks, which a figure cannot draw.
    axes.rows.push_back(boost::erase_all_copy(result.name + "\nagainst " + result.baseline, "`"));
    ratios.push_back(result.ratio);
  }
  axes.curves.push_back({"", {1.0, 1.0}, {-0.5, static_cast<double>(results.size()) - 0.5}, ":", 7});
  io::addSpreads(axes, "", ratios, 0.0, 0);
  return {"Time of the library against that of others: median over pairs of runs, quartiles", {axes}, 1};
}

}  // namespace rubber_suspension::benchmark
