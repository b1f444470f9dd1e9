// Figures, sent as JSON to scripts/plot_figures, which draws them in a separate process.
#include "rubber_suspension/io/figure.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/script.h"
#include "log/new_file.h"
#include "log/text.h"

namespace rubber_suspension::io {

using nlohmann::json;

// The JSON library finds these functions by argument-dependent lookup, so they cannot be in the unnamed namespace.
static void to_json(json& out, const Curve& curve) {
  out = {{"label", curve.label}, {"x", curve.x},           {"y", curve.y},
         {"style", curve.style}, {"colour", curve.colour}, {"width", curve.width}};
}

static void to_json(json& out, const HeatMap& map) {
  out = {{"x_edges", map.x_edges}, {"y_edges", map.y_edges}, {"values", map.values}, {"label", map.label}};
}

static void to_json(json& out, const Axes& axes) {
  out = {{"title", axes.title}, {"x_label", axes.x_label}, {"y_label", axes.y_label}, {"log_x", axes.log_x},
         {"log_y", axes.log_y}, {"rows", axes.rows},       {"curves", axes.curves},   {"maps", axes.maps}};
}

static void to_json(json& out, const Figure& figure) {
  out = {{"title", figure.title}, {"columns", figure.columns}, {"axes", figure.axes}};
}

namespace {

void checkSizes(const Figure& figure) {
  for (const Axes& axes : figure.axes) {
    for (const Curve& curve : axes.curves) {
      if (curve.x.size() != curve.y.size()) {
        throw FigureError(fmt::format("figure '{}', curve '{}': the curve has {} values of x but {} of y", figure.title,
                                      curve.label, curve.x.size(), curve.y.size()));
      }
    }
    for (const HeatMap& map : axes.maps) {
      const bool fits = map.x_edges.size() > 1 && map.y_edges.size() > 1 &&
                        map.values.size() == (map.x_edges.size() - 1) * (map.y_edges.size() - 1);
      if (!fits) {
        throw FigureError(fmt::format("figure '{}', map '{}': {} values do not fit {} x {} edges", figure.title,
                                      map.label, map.values.size(), map.x_edges.size(), map.y_edges.size()));
      }
    }
  }
}

}  // namespace

void addSpreads(Axes& axes, const std::string& label, const std::vector<Spread>& values, double offset, int colour) {
  Curve lines{"", {}, {}, "-", colour};
  Curve markers{label, {}, {}, "o", colour};
  for (std::size_t row = 0; row < values.size(); ++row) {
    const double y = static_cast<double>(row) + offset;
    const double gap = std::numeric_limits<double>::quiet_NaN();  // leaves a gap in the line between two rows
    lines.x.insert(lines.x.end(), {values[row].lower, values[row].upper, gap});
    lines.y.insert(lines.y.end(), {y, y, gap});
    markers.x.push_back(values[row].median);
    markers.y.push_back(y);
  }
  axes.curves.push_back(std::move(lines));
  axes.curves.push_back(std::move(markers));
}

bool isFigurePath(const std::string& path) { return log::endsWith(path, ".svg") || log::endsWith(path, ".png"); }

void drawFigure(const Figure& figure, const std::string& path) {
  if (!isFigurePath(path)) {
    throw FigureError(fmt::format("{}: is not the name of a figure; accepted: a name that ends in .svg or .png", path));
  }
  checkSizes(figure);
  try {
    log::NewFile file(path);
    const json request = {{"path", file.writingPath()}, {"figure", figure}};
    const ScriptResult drawing =
        runScript("plot_figures", {}, request.dump(-1, ' ', false, json::error_handler_t::replace));
    if (!drawing.succeeded) {
      throw FigureError(fmt::format("the figure was not drawn: {}", drawing.last_error));
    }
    file.commit();
  } catch (const FigureError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw FigureError(error.what());
  }
}

}  // namespace rubber_suspension::io
