// The numbers behind a figure of the report, as CSV.
#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "diagnosis/report/report_figures.h"

namespace rubber_suspension::diagnosis {
namespace {

// "displacement_mm" of "displacement [mm]", "gap" of "gap [-]".
std::string columnOf(const std::string& label) {
  std::string name;
  for (const char c : label) {
    const bool keep = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (keep) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (!name.empty() && name.back() == '_') {
    name.pop_back();
  }
  return name.empty() ? "value" : name;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    result += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' ? ' ' : c);
  }
  return result + "\"";
}

std::string curveRows(const io::Axes& axes) {
  std::string rows;
  for (const io::Curve& curve : axes.curves) {
    const std::string beginning = quoted(curve.label) + "," + quoted(axes.title);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) {
        rows += fmt::format("{},{:.9g},{:.9g}\n", beginning, curve.x[i], curve.y[i]);
      }
    }
  }
  return rows;
}

std::string mapRows(const io::Axes& axes) {
  std::string rows;
  for (const io::HeatMap& map : axes.maps) {
    const std::size_t width = map.x_edges.size() - 1;
    for (std::size_t i = 0; i < map.values.size(); ++i) {
      const std::size_t x = i % width;
      const std::size_t y = i / width;
      if (std::isfinite(map.values[i])) {
        rows += fmt::format("{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", quoted(map.label), quoted(axes.title),
                            map.x_edges[x], map.x_edges[x + 1], map.y_edges[y], map.y_edges[y + 1], map.values[i]);
      }
    }
  }
  return rows;
}

}  // namespace

std::string figureCsv(const io::Figure& figure) {
  if (figure.axes.empty()) {
    return "curve,panel\n";
  }
  const io::Axes& first = figure.axes.front();
  const std::string x = columnOf(first.x_label);
  const std::string y = columnOf(first.y_label);
  std::string text = first.maps.empty() ? fmt::format("curve,panel,{},{}\n", x, y)
                                        : fmt::format("curve,panel,{0}_low,{0}_high,{1}_low,{1}_high,value\n", x, y);
  for (const io::Axes& axes : figure.axes) {
    text += first.maps.empty() ? curveRows(axes) : mapRows(axes);
  }
  return text;
}

}  // namespace rubber_suspension::diagnosis
