// Measured logs that are not part of the package, for tests that can use them.
#pragma once

#include <cstdlib>
#include <string>

namespace rubber_suspension {

/// The path of a measured log below the folder that RUBBER_SUSPENSION_DATA names, or else below data/ of the package.
/// Nobody has to have it: a test without skips, and says what is missing.
inline std::string measuredData(const std::string& name) {
  const char* folder = std::getenv("RUBBER_SUSPENSION_DATA");
  return (folder != nullptr ? std::string(folder) : TEST_DIR "/../data") + "/" + name;
}

}  // namespace rubber_suspension
