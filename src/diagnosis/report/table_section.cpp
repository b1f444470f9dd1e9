// The table of a report.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/report/json_parts.h"
#include "diagnosis/report/page.h"
#include "diagnosis/report/text.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis {
namespace {

using nlohmann::ordered_json;

constexpr double kDegrees = 180.0 / element::kPi;

std::string stiffnessText(std::complex<double> stiffness) {
  return fmt::format("{:.4g} kN/mm, {:.3g}&deg;", 1e-6 * std::abs(stiffness), kDegrees * std::arg(stiffness));
}

bool any(const DiagnosedTable& table, bool (*has)(const fit::TablePoint&)) {
  return std::any_of(table.rows.begin(), table.rows.end(), [&](const DiagnosedRow& row) { return has(row.measured); });
}

std::string rowsHtml(const DiagnosedTable& diagnosed) {
  const bool means = any(diagnosed, [](const fit::TablePoint& point) { return point.mean != 0.0; });
  const bool temperatures = any(diagnosed, [](const fit::TablePoint& point) { return point.temperature.has_value(); });
  std::vector<std::string> titles = {"#frequency [Hz]", "#amplitude [mm]"};
  if (means) {
    titles.emplace_back("#about [mm]");
  }
  if (temperatures) {
    titles.emplace_back("#temperature [&deg;C]");
  }
  titles.insert(titles.end(), {"#measured", "#as configured", "#augmented", "#still off by"});
  Table table(titles);
  for (const DiagnosedRow& row : diagnosed.rows) {
    const fit::TablePoint& point = row.measured;
    std::vector<std::string> fields = {fmt::format("{:.4g}", point.frequency),
                                       fmt::format("{:.4g}", 1e3 * point.amplitude)};
    if (means) {
      fields.push_back(fmt::format("{:.4g}", 1e3 * point.mean));
    }
    if (temperatures) {
      fields.push_back(point.temperature ? fmt::format("{:.4g}", *point.temperature) : "");
    }
    const std::complex<double> measured = point.complexStiffness();
    fields.insert(fields.end(),
                  {stiffnessText(measured), stiffnessText(row.as_configured), stiffnessText(row.augmented),
                   percent(std::abs(row.augmented - measured) / std::abs(measured))});
    table.add(fields);
  }
  return table.html();
}

ordered_json stiffnessJson(std::complex<double> stiffness) {
  return {{"stiffness_N_per_m", std::abs(stiffness)}, {"loss_angle_rad", std::arg(stiffness)}};
}

ordered_json rowJson(const DiagnosedRow& row) {
  ordered_json json = {{"frequency_hz", row.measured.frequency},
                       {"amplitude_m", row.measured.amplitude},
                       {"mean_displacement_m", row.measured.mean}};
  if (row.measured.temperature) {
    json["temperature_degC"] = *row.measured.temperature;
  }
  json["measured"] = stiffnessJson(row.measured.complexStiffness());
  json["as_configured"] = stiffnessJson(row.as_configured);
  json["re_estimated"] = stiffnessJson(row.re_estimated);
  json["augmented"] = stiffnessJson(row.augmented);
  return json;
}

}  // namespace

std::string tableSection(const Diagnosis& diagnosis) {
  const DiagnosedTable& table = *diagnosis.table;
  std::vector<std::string> names;
  std::transform(table.never_shown.begin(), table.never_shown.end(), std::back_inserter(names), spoken);
  std::string notes;
  for (const std::string& note : table.notes) {
    notes += "<p class=note>" + escape(note) + "</p>\n";
  }
  return "<h2>The table</h2>\n<p>Rows of " + escape(table.name) +
         ": stiffness and loss angle of settled loops under single sines. Such a table can never show " +
         escape(enumerated(names)) +
         ", nor a delay that both channels share: these are neither found nor excluded here.</p>\n" + notes +
         folded(fmt::format("All {} rows, measured and simulated", table.rows.size()), rowsHtml(table));
}

ordered_json tableJson(const DiagnosedTable& table) {
  ordered_json rows = ordered_json::array();
  for (const DiagnosedRow& row : table.rows) {
    rows.push_back(rowJson(row));
  }
  return {{"name", table.name}, {"never_shown", table.never_shown}, {"notes", table.notes}, {"rows", rows}};
}

}  // namespace rubber_suspension::diagnosis
