// Contents of files and pages, and replacements in texts.
#pragma once

#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {

inline std::string firstLine(const std::filesystem::path& path) {
  const std::string text = contentOf(path);
  return text.substr(0, text.find('\n'));
}

/// Returns the text of docs/`name`.md.
inline std::string pageInDocs(const std::string& name) { return contentOf(TEST_DIR "/../docs/" + name + ".md"); }

/// Returns the sorted paths of the files with an extension in a folder of test/.
inline std::vector<std::string> filesIn(const std::string& folder, const std::string& extension) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(TEST_DIR "/" + folder)) {
    if (entry.path().extension() == extension) {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Returns the text with the first occurrence of `part` replaced. The test fails if the text does not contain `part`.
inline std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), by);
}

}  // namespace rubber_suspension
