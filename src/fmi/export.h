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

/// The bytes of a zip archive; the same for the same entries. Throws std::runtime_error.
std::string toZip(const std::vector<ArchiveEntry>& entries);

/// The files of an FMU that are the same for all components.
struct FmuParts {
  std::string binary;               ///< path of the shared library without a component, for Linux
  std::string sources;              ///< path of the folder of its sources
  std::string windows_binary = {};  ///< path of the same for Windows; empty: it was not built
};

/// Returns the parts built with the calling program, which are beside it, including that for Windows if it exists.
FmuParts installedParts();

/// Description of a component in an FMU: its elements complete, and a GUID that follows from it and the version of the
/// package.
ComponentData dataOf(const io::ComponentDescription& description);

/// The files in the FMU, the same for the same component. Throws std::runtime_error that names the file where a part is
/// missing or is no such part, and where the component is too large for it.
std::vector<ArchiveEntry> fmuFiles(const io::ComponentDescription& description, Version version, const FmuParts& parts);

}  // namespace rubber_suspension::fmi
