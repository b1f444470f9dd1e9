// Checks tables for `estimate --from-table`, and describes the fit to a table as text.
#include "command/table_fit_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "element/each.h"
#include "element/refuse.h"
#include "estimation/models.h"
#include "fit/residual_covariance.h"
#include "fit/table_fitter.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/measurement/bench_check.h"

namespace rubber_suspension::command {

void requireNoShift(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                    const std::string& source) {
  io::ComponentDescription unshifted = component;
  unshifted.temperature.reset();
  const bool temperatures = std::any_of(table.points.begin(), table.points.end(),
                                        [](const fit::TablePoint& point) { return point.temperature.has_value(); });
  element::refuseIf<std::runtime_error>(
      temperatures && unshifted.makeComponent().shiftsWithTemperature(),
      "{}: column temperature: {} has an element that shifts with temperature; accepted: a table without this column, "
      "a component with the shift in its key 'temperature', or diagnose --from-table",
      source, component.name);
}

std::vector<std::string> checkBenchOfTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                                           const std::string& source) {
  const auto finding = measurement::checkTable(source, element::each(table.points, &fit::TablePoint::complexStiffness),
                                               fit::TableLoops(table.points).stiffnessOf(component.allElements()),
                                               estimation::largestTolerance(component.specification()));
  const bool sign = finding && finding->finding == measurement::finding::kSign;
  if (!finding || (table.accept_units && !sign)) {
    return {};
  }
  element::refuseIf<std::runtime_error>(sign || measurement::isFarOff(*finding), "{}: {}", source, finding->text);
  return {finding->text};
}

namespace {

std::string spread(double value, double deviation) {
  return std::isfinite(deviation) ? fmt::format("{:.3f} +- {:.2g}", value, 1.96 * deviation)
                                  : fmt::format("{:.3f}, not determined", value);
}

std::string constantText(const fit::ShiftConstant& constant, const element::ElementDescription& law) {
  const auto& table = element::findElementType(law.type)->parameters;
  const std::string unit = element::findParameter(table, constant.name)->unit;
  return fmt::format("  {:<44} {:>14} {:>14.6g}{}\n", fmt::format("{} [{}]", constant.name, unit), "", constant.value,
                     constant.deviation < fit::kUndetermined ? fmt::format("  +- {:.2g} %", 196.0 * constant.deviation)
                                                             : "  not determined");
}

std::string toText(const fit::MasterCurve& curve) {
  const bool arrhenius = curve.law.type == "arrhenius_shift";
  std::string text = fmt::format("  master curve at {:g} degC, shifts according to {}\n", curve.law.value("reference"),
                                 arrhenius ? "Arrhenius" : "Williams, Landel and Ferry");
  text += fmt::format("  {:<44} {:>14} {:>14}\n", "temperature [degC]", "from law", "free");
  for (const fit::FoundShift& shift : curve.shifts) {
    text += fmt::format("  {:<44} {:>14.3f}   log10 a_T {}\n", fmt::format("{:.2f}", shift.temperature),
                        curve.decadesAt(shift.temperature), spread(shift.decades, shift.deviation));
  }
  for (const fit::ShiftConstant& constant : curve.constants) {
    text += constantText(constant, curve.law);
  }
  return text + fmt::format("  residual of the curve: {:.3g} % of K* with this law, {:.3g} % with free shifts\n",
                            100.0 * curve.misfit, 100.0 * curve.misfit_of_shifts);
}

}  // namespace

std::string toText(const fit::TableFit& fit, const fit::MeasuredTable& table) {
  std::string text = fmt::format("component {}, parameters from a table of {} points\n  {:<44} {:>14} {:>14}\n",
                                 fit.component.name, table.points.size(), "parameter", "given", "found");
  for (const fit::FittedParameter& parameter : fit.parameters) {
    text += fmt::format(
        "  {:<44} {:>14.6g} {:>14.6g}{}\n", parameter.name, parameter.given, parameter.value,
        parameter.determined ? fmt::format("  +- {:.2g} %", 196.0 * parameter.deviation) : "  not determined");
  }
  text += fit.master_curve ? toText(*fit.master_curve) : "";
  text += fmt::format("  mean difference of K*: {:.3g} % with the given values, {:.3g} % with the found values\n",
                      100.0 * fit.misfit_before, 100.0 * fit.misfit);
  text +=
      "  note: a table of settled loops under single sines cannot show softening, heating over time, an offset or a "
      "drift; a delay of the force appears as loss\n";
  for (const std::string& note : table.notes) {
    text += "  note: " + note + "\n";
  }
  return text;
}

}  // namespace rubber_suspension::command
