// Reads what the exporter packed.
#pragma once

#include <string>
#include <vector>

#include "fmi/export.h"

namespace rubber_suspension::fmi::test {

/// The files in a zip archive, folders left out. Throws std::runtime_error that begins with `source`, its name.
std::vector<ArchiveEntry> fromZip(const std::string& bytes, const std::string& source);

}  // namespace rubber_suspension::fmi::test
