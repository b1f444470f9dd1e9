// A component as an FMU: description, binary and sources in one archive.
#pragma once

#include <string>
#include <vector>

#include "fmi/model_description.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::fmi {

struct ArchiveEntry {
  std::string path;
  std::string content;
};

/// Returns the bytes of a zip archive, which depend on the entries only. Throws std::runtime_error.
std::string toZip(const std::vector<ArchiveEntry>& entries);

/// The files of an FMU that are the same for all components.
struct FmuParts {
  std::string binary;               ///< path of the shared library for Linux, without a component
  std::string sources;              ///< path of the folder with the sources of this library
  std::string windows_binary = {};  ///< path of the library for Windows; empty if it was not built
};

/// Returns the parts that are beside the calling program, including the library for Windows if it exists.
FmuParts installedParts();

/// Returns the data of a component for an FMU, with complete elements. The GUID depends on the description of the
/// component and the version of the package.
ComponentData dataOf(const io::ComponentDescription& description);

/// Returns the files in the FMU, which are the same for the same component. Throws std::runtime_error, which names the
/// file, if a part is missing or belongs to another version, or if the component is too large for the binary.
std::vector<ArchiveEntry> fmuFiles(const io::ComponentDescription& description, Version version, const FmuParts& parts);

}  // namespace rubber_suspension::fmi
