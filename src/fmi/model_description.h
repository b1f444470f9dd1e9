// modelDescription.xml: what an importer knows of an FMU before it loads the binary.
#pragma once

#include <string>

#include "fmi/runtime/variables.h"

namespace rubber_suspension::fmi {

/// Version of the standard.
enum class Version { fmi2, fmi3 };

/// The text of modelDescription.xml, in UTF-8. `tool` is the name and version of the exporter.
std::string modelDescription(const ComponentData& data, Version version, const std::string& tool);

}  // namespace rubber_suspension::fmi
