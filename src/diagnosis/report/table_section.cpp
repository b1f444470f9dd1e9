// The table of a report.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/report/page.h"
#include "diagnosis/report/text.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kDegrees = 180.0 / element::kPi;

std::string stiffnessText(std::complex<double> stiffness) {
  return fmt::format("{:.4g} kN/mm, {:.3g}&deg;", 1e-6 * std::abs(stiffness), kDegrees * std::arg(stiffness));
}

// Columns that no row of the table has are left out.
std::string rowsHtml(const std::vector<DiagnosedRow>& rows) {
  const auto any = [&](const auto& has) {
    return std::any_of(rows.begin(), rows.end(), [&](const DiagnosedRow& row) { return has(row.measured); });
  };
  const bool means = any([](const fit::TablePoint& point) { return point.mean != 0.0; });
  const bool temperatures = any([](const fit::TablePoint& point) { return point.temperature.has_value(); });
  const auto with = [&](Row fields, const std::string& mean, const std::string& temperature, const Row& rest) {
    fields.insert(fields.end(), means ? 1 : 0, mean);
    fields.insert(fields.end(), temperatures ? 1 : 0, temperature);
    fields.insert(fields.end(), rest.begin(), rest.end());
    return fields;
  };
  const Row titles = with({"#frequency [Hz]", "#amplitude [mm]"}, "#about [mm]", "#temperature [&deg;C]",
                          {"#measured", "#as configured", "#augmented", "#still off by"});
  return table(titles, rows, [&](const DiagnosedRow& row) {
    const fit::TablePoint& point = row.measured;
    const std::complex<double> measured = point.complexStiffness();
    return with({fmt::format("{:.4g}", point.frequency), fmt::format("{:.4g}", 1e3 * point.amplitude)},
                fmt::format("{:.4g}", 1e3 * point.mean),
                point.temperature ? fmt::format("{:.4g}", *point.temperature) : "",
                {stiffnessText(measured), stiffnessText(row.as_configured), stiffnessText(row.augmented),
                 percent(std::abs(row.augmented - measured) / std::abs(measured))});
  });
}

}  // namespace

std::string tableSection(const Diagnosis& diagnosis) {
  const DiagnosedTable& diagnosed = *diagnosis.table;
  std::vector<std::string> names;
  std::transform(diagnosed.never_shown.begin(), diagnosed.never_shown.end(), std::back_inserter(names), spoken);
  std::string notes;
  for (const std::string& note : diagnosed.notes) {
    notes += "<p class=note>" + escape(note) + "</p>\n";
  }
  return "<h2>The table</h2>\n<p>Rows of " + escape(diagnosed.name) +
         ": stiffness and loss angle of settled loops under single sines. Such a table can never show " +
         escape(enumerated(names)) +
         ", nor a delay that both channels share: these are neither found nor excluded here.</p>\n" + notes +
         folded(fmt::format("All {} rows, measured and simulated", diagnosed.rows.size()), rowsHtml(diagnosed.rows));
}

}  // namespace rubber_suspension::diagnosis
