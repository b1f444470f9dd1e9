// Reads the archive of the exporter.
#pragma once

#include <string>
#include <vector>

#include "fmi/export.h"

namespace rubber_suspension::fmi::test {

/// Returns the files of a zip archive without folders. Throws std::runtime_error; its message begins with `source`.
std::vector<ArchiveEntry> fromZip(const std::string& bytes, const std::string& source);

}  // namespace rubber_suspension::fmi::test
