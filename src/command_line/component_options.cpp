// The options --config and --component.
#include "command_line/component_options.h"

#include "command_line/warnings.h"

namespace rubber_suspension::command_line {

OptionTable ComponentOptions::table() {
  return {Option("--config", config, "FILE", "component file").required(),
          Option("--component", component, "NAME", "name of the component; may be left out where there is one")};
}

io::ComponentDescription ComponentOptions::read(const std::string& command) const {
  io::ComponentDescription description = io::selectComponent(io::loadComponentFile(config), component, config);
  warnOf(command, description);
  return description;
}

}  // namespace rubber_suspension::command_line
