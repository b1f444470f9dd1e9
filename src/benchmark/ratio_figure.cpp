// The table of the benchmark as a figure.
#include "benchmark/ratio_figure.h"

#include <algorithm>
#include <string>

namespace rubber_suspension::benchmark {
namespace {

// Code is set off by backticks in the table, which a figure does not know.
std::string rowName(const Result& result) {
  std::string name = result.name + "\nagainst " + result.baseline;
  name.erase(std::remove(name.begin(), name.end(), '`'), name.end());
  return name;
}

}  // namespace

io::Figure ratioFigure(const std::vector<Result>& results) {
  io::Axes axes;
  axes.x_label = "time of the library / time of the plain loop [-]";
  axes.log_x = true;
  std::vector<io::Spread> ratios;
  for (const Result& result : results) {
    axes.rows.push_back(rowName(result));
    ratios.push_back({result.ratio, result.lowest, result.highest});
  }
  axes.curves.push_back({"", {1.0, 1.0}, {-0.5, static_cast<double>(results.size()) - 0.5}, ":", 7});
  io::addSpreads(axes, "", ratios, 0.0, 0);
  return {"Time against loops written by hand: median over pairs of runs, quartiles", {axes}, 1};
}

}  // namespace rubber_suspension::benchmark
