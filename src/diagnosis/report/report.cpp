// The report's files.
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <vector>

#include "log/new_file.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {
namespace {

// Written, not yet in place: the report is complete or the older one stays.
std::unique_ptr<log::NewFile> writeBeside(const std::filesystem::path& path, const std::string& text) {
  auto file = std::make_unique<log::NewFile>(path.string());
  std::ofstream stream(file->writingPath(), std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) {
    throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(errno));
  }
  return file;
}

}  // namespace

void writeReport(const Diagnosis& diagnosis, const std::string& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    throw std::runtime_error(folder + ": cannot be made: " + failure.message());
  }
  const std::filesystem::path base(folder);
  std::vector<std::unique_ptr<log::NewFile>> files;
  files.push_back(writeBeside(base / "report.json", toJson(diagnosis)));
  if (diagnosis.workings) {
    files.push_back(writeBeside(base / "augmented.yaml", io::toYaml({diagnosis.augmented})));
  }
  files.push_back(writeBeside(base / "report.html", toHtml(diagnosis)));
  if (!diagnosis.workings) {  // the logs cannot be what they say: that of an earlier run would be taken for theirs
    std::filesystem::remove(base / "augmented.yaml", failure);
  }
  for (const auto& file : files) {  // the page comes last: it speaks of the others
    file->commit();
  }
}

}  // namespace rubber_suspension::diagnosis
