// The reference pages of docs/, to be compared with what the code prints.
#pragma once

#include <fstream>
#include <sstream>
#include <string>

namespace rubber_suspension {

/// The text of docs/`name`.md.
inline std::string pageInDocs(const std::string& name) {
  std::ostringstream page;
  page << std::ifstream(TEST_DIR "/../docs/" + name + ".md").rdbuf();
  return page.str();
}

}  // namespace rubber_suspension
