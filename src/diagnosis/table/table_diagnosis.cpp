// The diagnosis from a table to a result: the bench, search, judgement, description.
#include "rubber_suspension/diagnosis/table_diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/refused.h"
#include "diagnosis/table/describe_table.h"
#include "diagnosis/table/row_table.h"
#include "measurement/statistics.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/measurement/bench_check.h"

namespace rubber_suspension::diagnosis {
namespace {

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
                                     magnitudesOf(measured.loops().stiffnessOf(component.allElements())));
}

}  // namespace

Diagnosis diagnoseTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                        const DiagnosisOptions& options) {
  checkRows(component, table);
  const MeasuredRows measured(component, table.points, scatterOf(table.points, table.uncertainty));
  if (const auto finding = benchFinding(component, table, measured)) {
    Diagnosis result = refused(component, {*finding});
    result.table = DiagnosedTable{table.name, {}, neverShownByTables(), table.notes};
    return result;
  }
  auto workings = std::make_shared<Workings>();
  workings->search = search(measured, options.threads, options.progress);
  workings->evidence = evidenceOf(workings->search);
  addRows(measured, workings->search, options.threads, workings->evidence);
  workings->write_evidence = options.evidence;
  workings->answer = answer(workings->evidence);
  return describeTable(component, table, measured, std::move(workings), options);
}

}  // namespace rubber_suspension::diagnosis
