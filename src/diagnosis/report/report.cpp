// The report's files.
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {
namespace {

void writeText(const std::filesystem::path& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  if (!stream.flush()) {
    throw std::runtime_error(path.string() + ": cannot be written");
  }
}

}  // namespace

void writeReport(const Diagnosis& diagnosis, const std::string& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    throw std::runtime_error(folder + ": cannot be made: " + failure.message());
  }
  const std::filesystem::path base(folder);
  writeText(base / "report.json", toJson(diagnosis));
  if (diagnosis.workings) {
    writeText(base / "augmented.yaml", io::toYaml({diagnosis.augmented}));
  } else {  // the logs cannot be what they say: that of an earlier run would be taken for theirs
    std::filesystem::remove(base / "augmented.yaml", failure);
  }
  writeText(base / "report.html", toHtml(diagnosis));
}

}  // namespace rubber_suspension::diagnosis
