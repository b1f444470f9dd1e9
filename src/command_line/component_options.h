// The options --config, --component and --without-rig of commands that work on one component.
#pragma once

#include <string>

#include "command_line/option_table.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::command_line {

/// Returns the option --without-rig. The flag must outlive the option.
Option withoutRigOption(bool& without_rig);

struct ComponentOptions {
  std::string config;
  std::string component;
  bool without_rig = false;

  OptionTable table();

  /// Returns the component that the options select, and prints warnings about its specification. Throws
  /// io::ComponentFileError, also if the component has six directions.
  io::ComponentDescription read(const std::string& command) const;

  /// Returns the component as read() does, and also accepts six directions.
  io::ComponentDescription readAny(const std::string& command) const;
};

}  // namespace rubber_suspension::command_line
