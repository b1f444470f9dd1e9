// A component as an FMU: description, binary and sources in one archive.
#pragma once

#include <string>
#include <vector>

#include "fmi/model_description.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::fmi {

/// A file in an archive: its path, with slashes, and its content.
struct ArchiveEntry {
  std::string path;
  std::string content;
};

/// Returns the bytes of a zip archive; the same for the same entries. Throws std::runtime_error.
std::string toZip(const std::vector<ArchiveEntry>& entries);

/// The files of an FMU that are the same for all components.
struct FmuParts {
  std::string binary;               ///< path of the shared library without a component, for Linux
  std::string sources;              ///< path of the folder of its sources
  std::string windows_binary = {};  ///< path of the library for Windows; empty if it was not built
};

/// Returns the parts built with the calling program, which are beside it, with that for Windows if it exists.
FmuParts installedParts();

/// Returns the description of a component for an FMU: complete elements, and a GUID that depends on the description and
/// the version of the package.
ComponentData dataOf(const io::ComponentDescription& description);

/// Returns the files in the FMU, the same for the same component. Throws std::runtime_error that names the file if a
/// part is missing or is not one of this version, or if the component is too large for it.
std::vector<ArchiveEntry> fmuFiles(const io::ComponentDescription& description, Version version, const FmuParts& parts);

}  // namespace rubber_suspension::fmi
