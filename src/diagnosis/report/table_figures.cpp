// Computes the figures of a report on a table: measured and simulated stiffness and loss angle, and the map of the gap.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/report/report_figures.h"
#include "element/each.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::report {
namespace {

constexpr std::size_t kMostPanels = 6;

using Rows = std::vector<DiagnosedRow>;

// Rows of the table in one panel. They differ only in the quantity on the axis.
struct Panel {
  std::string title;
  Rows rows;
  double squares = 0.0;  // part of the squared gap as configured
};

double over(const fit::TablePoint& point, bool along_frequency) {
  return along_frequency ? point.frequency : 1e3 * point.amplitude;
}

std::string titleOf(const fit::TablePoint& point, bool along_frequency) {
  std::string title =
      along_frequency ? fmt::format("{:.4g} mm", 1e3 * point.amplitude) : fmt::format("{:.4g} Hz", point.frequency);
  if (point.mean != 0.0) {
    title += fmt::format(" about {:.4g} mm", 1e3 * point.mean);
  }
  return point.temperature ? title + fmt::format(", {:.4g} degC", *point.temperature) : title;
}

bool severalFrequencies(const Rows& rows) {
  return std::any_of(rows.begin(), rows.end(), [&](const DiagnosedRow& row) {
    return std::abs(row.measured.frequency / rows.front().measured.frequency - 1.0) > 1e-6;
  });
}

// Returns panels in descending order of their gap. The rows of each are sorted along the axis.
std::vector<Panel> panelsOf(const Rows& rows, bool along_frequency) {
  std::map<std::string, Panel> by_title;
  for (const DiagnosedRow& row : rows) {
    Panel& panel = by_title[titleOf(row.measured, along_frequency)];
    panel.title = titleOf(row.measured, along_frequency);
    panel.squares += std::norm(row.as_configured / row.measured.complexStiffness() - 1.0);
    panel.rows.push_back(row);
  }
  std::vector<Panel> panels;
  for (auto& [title, panel] : by_title) {
    std::stable_sort(panel.rows.begin(), panel.rows.end(), [&](const DiagnosedRow& x, const DiagnosedRow& y) {
      return over(x.measured, along_frequency) < over(y.measured, along_frequency);
    });
    panels.push_back(std::move(panel));
  }
  std::stable_sort(panels.begin(), panels.end(), [](const Panel& x, const Panel& y) { return x.squares > y.squares; });
  panels.resize(std::min(panels.size(), kMostPanels));
  return panels;
}

using PartOfStiffness = double (*)(std::complex<double>);

io::Axes axesOf(const Panel& panel, bool along_frequency, const char* label, PartOfStiffness value) {
  io::Axes axes{panel.title, along_frequency ? "frequency [Hz]" : "amplitude [mm]", label, true};
  const auto x = element::each(panel.rows, [&](const auto& row) { return over(row.measured, along_frequency); });
  const auto values = [&](const auto& stiffness) {
    return element::each(panel.rows, [&](const DiagnosedRow& row) { return value(std::invoke(stiffness, row)); });
  };
  const auto measured = [](const DiagnosedRow& row) { return row.measured.complexStiffness(); };
  axes.curves = {{"measured", x, values(measured), "o", 0},
                 {"before: as configured", x, values(&DiagnosedRow::as_configured), "--", 1},
                 {"after: augmented", x, values(&DiagnosedRow::augmented), "-", io::kInk}};
  return axes;
}

io::Figure panelFigure(const Diagnosis& diagnosis, const char* title, const char* label, PartOfStiffness value) {
  const Rows& rows = diagnosis.table->rows;
  io::Figure figure{title};
  const bool along_frequency = severalFrequencies(rows);
  for (const Panel& panel : panelsOf(rows, along_frequency)) {
    figure.axes.push_back(axesOf(panel, along_frequency, label, value));
  }
  return figure;
}

// Returns edges of cells around these values, half-way between them on a logarithmic axis.
std::vector<double> edgesAbout(std::vector<double> values) {
  values = sortedApart(std::move(values));
  if (values.size() < 2) {
    return {};
  }
  std::vector<double> edges = {values[0] * std::sqrt(values[0] / values[1])};
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    edges.push_back(std::sqrt(values[i] * values[i + 1]));
  }
  edges.push_back(values.back() * values.back() / edges.back());
  return edges;
}

// Returns a map over frequency and amplitude, in which all preloads and temperatures are added.
io::Figure mapFigure(const Diagnosis& diagnosis) {
  const auto lower_end = [](auto band) { return [band](const gap::GapCell& cell) { return (cell.*band)[0]; }; };
  return shareMap(diagnosis.where.before,
                  edgesAbout(element::each(diagnosis.where.before, lower_end(&gap::GapCell::frequency))),
                  edgesAbout(element::each(diagnosis.where.before, lower_end(&gap::GapCell::amplitude))));
}

}  // namespace

std::vector<ReportFigure> tableFigures(const Diagnosis& diagnosis) {
  return {{kStiffness, "Stiffness of the settled loops, measured and simulated.",
           panelFigure(diagnosis, "Stiffness", "stiffness [kN/mm]",
                       [](std::complex<double> stiffness) { return 1e-6 * std::abs(stiffness); })},
          {kWhere, "Where the squared gap lies, over the rows of the table.", mapFigure(diagnosis)},
          {kLossAngle, "Loss angle of the settled loops, measured and simulated.",
           panelFigure(diagnosis, "Loss angle", "loss angle [deg]",
                       [](std::complex<double> stiffness) { return std::arg(stiffness) * 180.0 / element::kPi; })}};
}

}  // namespace rubber_suspension::diagnosis::report
