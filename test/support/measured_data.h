// Measured logs that are not part of the package. Tests use them if they are present.
#pragma once

#include <cstdlib>
#include <string>

namespace rubber_suspension {

/// Returns the path of a measured log in the folder RUBBER_SUSPENSION_DATA, or in data/ of the package if this variable
/// is not set. A test without its log is skipped and names the log.
inline std::string measuredData(const std::string& name) {
  const char* folder = std::getenv("RUBBER_SUSPENSION_DATA");
  return (folder != nullptr ? std::string(folder) : TEST_DIR "/../data") + "/" + name;
}

}  // namespace rubber_suspension
