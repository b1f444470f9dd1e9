// The options --config, --component and --without-rig.
#include "command_line/component_options.h"

#include "command_line/warnings.h"
#include "element/refuse.h"

namespace rubber_suspension::command_line {

Option withoutRigOption(bool& without_rig) {
  return Option("--without-rig", without_rig,
                "omit elements that describe the test rig: entries with of_rig, and delay, gain, zero and drift of the "
                "measuring chain")
      .rare();
}

OptionTable ComponentOptions::table() {
  return {Option("--config", config, "FILE", "component file").required().reads(),
          Option("--component", component, "NAME", "name of the component; needed if the file has several components"),
          withoutRigOption(without_rig)};
}

io::ComponentDescription ComponentOptions::read(const std::string& command) const {
  io::ComponentDescription description = readAny(command);
  element::refuseIf<io::ComponentFileError>(
      description.six != nullptr,
      "{}: component '{}' has six directions, but {} needs one; accepted: a component of one direction, such as one of "
      "its `directions` in a file of its own",
      config, description.name, command);
  return description;
}

io::ComponentDescription ComponentOptions::readAny(const std::string& command) const {
  io::ComponentDescription description = io::selectComponent(io::loadComponentFile(config), component, config);
  warnOf(command, description);
  return without_rig ? description.withoutRig() : description;
}

}  // namespace rubber_suspension::command_line
