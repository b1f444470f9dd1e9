// Figures as data, which Matplotlib draws in a separate process.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rubber_suspension::io {

/// Index of the colour of text, which is not in the palette.
constexpr int kInk = -2;

/// One curve, or a set of markers.
struct Curve {
  std::string label;  ///< text in the legend; empty: no entry
  std::vector<double> x;
  std::vector<double> y;
  std::string style = "-";  ///< Matplotlib's line or marker format, "-", "--", "o", ...
  int colour = -1;          ///< index into the palette, or kInk; -1: the next colour
  double width = 0.0;       ///< width of the line [pt]; 0: Matplotlib's default
};

/// A map of values over a grid, drawn as an image with a colour bar.
struct HeatMap {
  std::vector<double> x_edges;
  std::vector<double> y_edges;
  std::vector<double> values;  ///< values row by row along y; NaN leaves a cell blank
  std::string label;           ///< label of the colour bar, with unit
};

struct Axes {
  std::string title;
  std::string x_label;  ///< text with unit, such as "frequency [Hz]"
  std::string y_label;
  bool log_x = false;
  bool log_y = false;
  std::vector<std::string> rows = {};  ///< labels of y = 0, 1, 2, ... from the top down; empty: y is a number
  std::vector<Curve> curves = {};
  std::vector<HeatMap> maps = {};  ///< at most one map
};

struct Figure {
  std::string title;
  std::vector<Axes> axes = {};
  int columns = 2;  ///< number of columns in the grid of axes
};

/// A measured value with the quartiles of its repetitions.
struct Spread {
  double median = 0.0;
  double lower = 0.0;
  double upper = 0.0;
};

/// Adds one value to each row of axes that have rows: a marker at the median and a line from quartile to quartile,
/// `offset` rows below the middle of the row. `colour` is an index into the palette.
void addSpreads(Axes& axes, const std::string& label, const std::vector<Spread>& values, double offset, int colour);

class FigureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns true for the names that drawFigure() accepts: FILE.svg and FILE.png.
bool isFigurePath(const std::string& path);

/// Draws a figure to FILE.svg or FILE.png. Throws FigureError for any other name, and if drawing fails.
void drawFigure(const Figure& figure, const std::string& path);

}  // namespace rubber_suspension::io
