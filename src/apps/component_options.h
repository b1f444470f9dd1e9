// The options --config and --component, the same for every command that works on one component.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "apps/warnings.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::apps {

struct ComponentOptions {
  std::string config;
  std::string component;

  /// Adds both; the object has to live as long as the parser.
  void addTo(CLI::App& app) {
    app.add_option("--config", config, "component file")->required()->type_name("FILE");
    app.add_option("--component", component, "name of the component; may be left out where there is one")
        ->type_name("NAME");
  }

  /// The component that they name, with a warning where its specification is odd. Throws io::ComponentFileError.
  io::ComponentDescription read(const std::string& command) const {
    io::ComponentDescription description = io::selectComponent(io::loadComponentFile(config), component, config);
    warnOf(command, description);
    return description;
  }
};

}  // namespace rubber_suspension::apps
