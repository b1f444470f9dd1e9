// Reads the archive of the exporter with libzip.
#include "fmi/zip_reader.h"

#include <zip.h>

#include <memory>
#include <stdexcept>

namespace rubber_suspension::fmi::test {
namespace {

void require(bool condition, const std::string& what) {
  if (!condition) {
    throw std::runtime_error(what);
  }
}

}  // namespace

std::vector<ArchiveEntry> fromZip(const std::string& bytes, const std::string& source) {
  zip_source_t* const buffer = zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr);
  const std::unique_ptr<zip_t, void (*)(zip_t*)> archive(zip_open_from_source(buffer, ZIP_RDONLY, nullptr),
                                                         zip_discard);
  require(archive != nullptr, source + ": no archive");
  std::vector<ArchiveEntry> entries;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
    zip_stat_t status;
    require(zip_stat_index(archive.get(), i, 0, &status) == 0, source + ": " + zip_strerror(archive.get()));
    const std::string path = status.name;
    if (path.empty() || path.back() != '/') {
      const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen_index(archive.get(), i, 0), zip_fclose);
      std::string content(status.size, '\0');
      require(file && zip_fread(file.get(), content.data(), status.size) == static_cast<zip_int64_t>(status.size),
              source + ": " + path + " cannot be read");
      entries.push_back({path, std::move(content)});
    }
  }
  return entries;
}

}  // namespace rubber_suspension::fmi::test
