// Errors and sizes by row.
#include "diagnosis/table/row_table.h"

#include <algorithm>
#include <complex>
#include <iterator>
#include <limits>

#include "diagnosis/hypotheses/log_table.h"
#include "fit/parallel.h"

namespace rubber_suspension::diagnosis {
namespace {

using Stiffness = std::vector<std::complex<double>>;

std::vector<double> squaresOf(const std::vector<fit::TablePoint>& points, const Stiffness& one,
                              const Stiffness& other) {
  std::vector<double> squares;
  for (std::size_t r = 0; r < points.size(); ++r) {
    const double square = std::norm((one[r] - other[r]) / points[r].stiffness);
    squares.push_back(std::isfinite(square) ? square : std::numeric_limits<double>::infinity());
  }
  return squares;
}

std::vector<double> errorsAsConfigured(const MeasuredRows& measured, const FittedHypothesis& configured) {
  const std::vector<fit::TablePoint>& points = measured.loops().points();
  Stiffness of_table;
  std::transform(points.begin(), points.end(), std::back_inserter(of_table),
                 [](const fit::TablePoint& point) { return point.complexStiffness(); });
  return squaresOf(points, of_table, *measured.fitter().stiffness(configured.hypothesis, configured.fit.parameters));
}

std::vector<double> heldOutErrors(const fit::Fit& fit) {
  std::vector<double> errors;
  std::transform(fit.blocks.begin(), fit.blocks.end(), std::back_inserter(errors),
                 [](const gap::PartError& row) { return row.error; });
  return errors;
}

std::vector<std::vector<double>> sizesOf(const MeasuredRows& measured, const Search& search,
                                         const FittedHypothesis& fitted) {
  const Stiffness with = *measured.fitter().stiffness(fitted.hypothesis, fitted.fit.parameters);
  std::vector<std::vector<double>> sizes;
  for (std::size_t m = 0; m < fitted.hypothesis.members.size(); ++m) {
    const Stiffness without =
        *measured.fitter().stiffness(fitted.hypothesis, withoutMember(search.candidates, fitted, m));
    sizes.push_back(squaresOf(measured.loops().points(), with, without));
  }
  return sizes;
}

}  // namespace

void addRows(const MeasuredRows& measured, const Search& search, int threads, Evidence& evidence) {
  evidence.logs.assign(measured.loops().points().size(), {search.noise, 0.0, 1.0, false, 1});
  fit::parallelFor(evidence.hypotheses.size(), threads, [&](std::size_t h) {
    const FittedHypothesis& fitted = search.at(static_cast<int>(h));
    evidence.hypotheses[h].log_errors =
        h == Evidence::kAsConfigured ? errorsAsConfigured(measured, fitted) : heldOutErrors(fitted.fit);
    evidence.hypotheses[h].sizes = sizesOf(measured, search, fitted);
  });
}

}  // namespace rubber_suspension::diagnosis
