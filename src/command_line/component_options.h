// The options --config and --component, the same for every command that works on one component.
#pragma once

#include <string>

#include "command_line/option_table.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::command_line {

/// --without-rig. The flag has to outlive the option.
Option withoutRigOption(bool& without_rig);

struct ComponentOptions {
  std::string config;
  std::string component;
  bool without_rig = false;

  OptionTable table();

  /// The component that they name, without the rig where they say so; with a warning where its specification is odd.
  /// Throws io::ComponentFileError. Refuses a component of six directions likewise.
  io::ComponentDescription read(const std::string& command) const;

  /// Accepts any number of directions.
  io::ComponentDescription readAny(const std::string& command) const;
};

}  // namespace rubber_suspension::command_line
