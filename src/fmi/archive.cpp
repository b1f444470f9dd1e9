// Zip archives in memory, by libzip.
#include "fmi/archive.h"

#include <zip.h>

#include <memory>

#include "element/refuse.h"

namespace rubber_suspension::fmi {
namespace {

// 2 January 1980, since zip has no earlier year and keeps local time: the same bytes today and tomorrow.
constexpr time_t kTimeOfFiles = 315619200;

void require(bool done, const std::string& name, const char* reason) {
  element::refuseIf<std::runtime_error>(!done, "{}: {}", name, reason);
}

}  // namespace

std::string toZip(const std::vector<ArchiveEntry>& entries) {
  const std::string name = "zip archive";
  const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> whole(zip_source_buffer_create(nullptr, 0, 0, nullptr),
                                                                     zip_source_free);
  std::unique_ptr<zip_t, void (*)(zip_t*)> archive(
      zip_open_from_source(whole.get(), ZIP_CREATE | ZIP_TRUNCATE, nullptr), zip_discard);
  require(archive != nullptr, name, "cannot be begun");
  zip_source_keep(whole.get());  // which is the archive's, too
  for (const ArchiveEntry& entry : entries) {
    zip_source_t* const content = zip_source_buffer(archive.get(), entry.content.data(), entry.content.size(), 0);
    const zip_int64_t index = zip_file_add(archive.get(), entry.path.c_str(), content, ZIP_FL_ENC_UTF_8);
    if (index < 0) {  // else it is the archive's
      zip_source_free(content);
    }
    require(index >= 0, entry.path, zip_strerror(archive.get()));
    zip_file_set_mtime(archive.get(), static_cast<zip_uint64_t>(index), kTimeOfFiles, 0);
  }
  require(zip_close(archive.get()) == 0, name, zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // closed
  require(zip_source_open(whole.get()) == 0 && zip_source_seek(whole.get(), 0, SEEK_END) == 0, name, "no bytes");
  std::string bytes(static_cast<std::size_t>(zip_source_tell(whole.get())), '\0');
  zip_source_seek(whole.get(), 0, SEEK_SET);
  const zip_int64_t count = zip_source_read(whole.get(), bytes.data(), bytes.size());
  zip_source_close(whole.get());
  require(count == static_cast<zip_int64_t>(bytes.size()), name, "cannot be read back");
  return bytes;
}

}  // namespace rubber_suspension::fmi
