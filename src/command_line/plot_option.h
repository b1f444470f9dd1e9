// The option --plot of commands whose results can be drawn as curves.
#pragma once

#include <string>

#include "command_line/option_table.h"
#include "io/progress.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::command_line {

/// Returns the option --plot with the help "figure to draw, .svg or .png: `what`". Other extensions are refused.
inline Option plotOption(std::string& path, const std::string& what) {
  return Option("--plot", path, "FILE", "figure to draw, .svg or .png: " + what)
      .writes(io::file_kind::figure)
      .checkedBy([](const std::string& name) {
        return name.empty() || io::isFigurePath(name) ? "" : name + "; accepted: a name that ends in .svg or .png";
      });
}

/// Draws the figure that `make` returns, if a path is given. Throws io::FigureError.
template <class Make>
void drawPlot(const std::string& path, Make make) {
  if (!path.empty()) {
    const io::Figure figure = make();
    const io::Activity drawing("drawing " + path);
    io::drawFigure(figure, path);
  }
}

}  // namespace rubber_suspension::command_line
