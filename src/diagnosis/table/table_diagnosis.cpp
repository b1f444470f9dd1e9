// The diagnosis from a table to a result: the bench, search, judgement, description.
#include "rubber_suspension/diagnosis/table_diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>

#include "diagnosis/hypotheses/log_table.h"
#include "diagnosis/hypotheses/search.h"
#include "diagnosis/invariants.h"
#include "diagnosis/judge/evidence.h"
#include "diagnosis/refused.h"
#include "diagnosis/table/describe_table.h"
#include "estimation/models.h"
#include "fit/parallel.h"
#include "measurement/statistics.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/measurement/bench_check.h"

namespace rubber_suspension::diagnosis {
namespace {

using table::MeasuredRows;

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

std::vector<double> errorsAsConfigured(const MeasuredRows& measured, const hypotheses::FittedHypothesis& configured) {
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

std::vector<std::vector<double>> sizesOf(const MeasuredRows& measured, const hypotheses::FittedHypothesis& fitted) {
  const Stiffness with = *measured.fitter().stiffness(fitted.hypothesis, fitted.fit.parameters);
  std::vector<std::vector<double>> sizes;
  for (std::size_t m = 0; m < fitted.hypothesis.members.size(); ++m) {
    const Stiffness without = *measured.fitter().stiffness(fitted.hypothesis, hypotheses::withoutMember(fitted, m));
    sizes.push_back(squaresOf(measured.loops().points(), with, without));
  }
  return sizes;
}

// The evidence of a search over the rows of a table, each as a log under one sine: log_errors and sizes of each
// hypothesis are squares of differences of K* over |K*|.
judge::Evidence evidenceOfRows(const MeasuredRows& measured, const hypotheses::Search& search, int threads) {
  judge::Evidence evidence = hypotheses::evidenceOf(search);
  evidence.logs.assign(measured.loops().points().size(), {search.noise.floor, 0.0, 1.0, false, 1});
  fit::parallelFor(evidence.hypotheses.size(), threads, [&](std::size_t h) {
    const hypotheses::FittedHypothesis& fitted = search.at(static_cast<int>(h));
    evidence.hypotheses[h].log_errors =
        h == judge::Evidence::kAsConfigured ? errorsAsConfigured(measured, fitted) : heldOutErrors(fitted.fit);
    evidence.hypotheses[h].sizes = sizesOf(measured, fitted);
  });
  return evidence;
}

void checkRows(const io::ComponentDescription& component, const fit::MeasuredTable& table) {
  if (table.points.size() < kFewestRows) {
    throw std::invalid_argument(fmt::format("{}: {} rows; accepted: at least {}, over frequency and amplitude",
                                            table.name, table.points.size(), kFewestRows));
  }
  const component::Component built = component.makeComponent();
  for (const element::ElementDescription& element : built.elements()) {
    if (element.type == "self_heating") {
      throw std::invalid_argument(
          fmt::format("{}: has self_heating, which a table has in the state that each sine ends in; accepted: logs, or "
                      "the component without it",
                      component.name));
    }
  }
  const auto has_temperature = [](const fit::TablePoint& point) { return point.temperature.has_value(); };
  const auto having = std::count_if(table.points.begin(), table.points.end(), has_temperature);
  if (built.shiftsWithTemperature() && having == 0) {
    throw std::invalid_argument(
        fmt::format("{}: shifts with temperature, and {} has no column temperature; accepted: "
                    "a table with 'temperature [degC]'",
                    component.name, table.name));
  }
  for (const fit::TablePoint& point : table.points) {
    if (point.temperature && !built.temperatures().contains(*point.temperature)) {
      throw std::invalid_argument(fmt::format("{}: temperature {:g} degC; accepted: {}", table.name, *point.temperature,
                                              element::describe(built.temperatures()) + " degC"));
    }
  }
}

std::vector<double> magnitudesOf(const std::vector<std::complex<double>>& stiffness) {
  std::vector<double> magnitudes;
  std::transform(stiffness.begin(), stiffness.end(), std::back_inserter(magnitudes),
                 [](std::complex<double> k) { return std::abs(k); });
  return magnitudes;
}

std::optional<measurement::RigFinding> benchFinding(const io::ComponentDescription& component,
                                                    const fit::MeasuredTable& table, const MeasuredRows& measured) {
  if (table.accept_units) {
    return std::nullopt;
  }
  std::vector<double> of_table;
  std::transform(table.points.begin(), table.points.end(), std::back_inserter(of_table),
                 [](const fit::TablePoint& point) { return point.stiffness; });
  return measurement::checkStiffness(table.name, of_table,
                                     magnitudesOf(measured.loops().stiffnessOf(component.allElements())),
                                     estimation::largestTolerance(component.specification()));
}

}  // namespace

Diagnosis diagnoseTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                        const DiagnosisOptions& options) {
  checkRows(component, table);
  const MeasuredRows measured(component, table.points, table::scatterOf(table.points, table.uncertainty));
  if (const auto finding = benchFinding(component, table, measured)) {
    Diagnosis result = refused(component, {*finding});
    result.table = DiagnosedTable{table.name, {}, table::neverShownByTables(), table.notes};
    return result;
  }
  hypotheses::Search search =
      hypotheses::search(measured, hypotheses::excludedEffects(component, options), options.threads, options.progress);
  judge::Evidence evidence = evidenceOfRows(measured, search, options.threads);
  judge::Answer answer = judge::answer(evidence);
  auto workings = std::make_shared<const Workings>(
      Workings{std::move(search), std::move(evidence), std::move(answer), options.evidence, {}});
  return heldToInvariants(table::describeTable(component, table, measured, std::move(workings), options));
}

}  // namespace rubber_suspension::diagnosis
