// The option --plot, the same for every command that ends in numbers over an axis.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::apps {

/// Adds --plot; `what` is drawn: "figure of `what` to draw". Another extension is refused before any work is done.
inline void addPlotOption(CLI::App& app, std::string& path, const std::string& what) {
  const auto problem = [](const std::string& name) {
    return name.empty() || io::isFigurePath(name) ? "" : name + "; accepted: a name that ends in .svg or .png";
  };
  app.add_option("--plot", path, "figure of " + what + " to draw, .svg or .png")->check(problem)->type_name("FILE");
}

}  // namespace rubber_suspension::apps
