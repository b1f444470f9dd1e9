// Zip archives in memory, by libzip.
#include "fmi/archive.h"

#include <zip.h>

#include <memory>
#include <stdexcept>

namespace rubber_suspension::fmi {
namespace {

// 2 January 1980, since zip has no earlier year and keeps local time: the same bytes today and tomorrow.
constexpr time_t kTimeOfFiles = 315619200;

using Archive = std::unique_ptr<zip_t, void (*)(zip_t*)>;
using Source = std::unique_ptr<zip_source_t, void (*)(zip_source_t*)>;

// Calls with a place for an error, which becomes an exception that begins with `name`.
template <class Call>
auto checked(const std::string& name, Call call) {
  zip_error_t error;
  zip_error_init(&error);
  const auto result = call(&error);
  const std::string reason = result == nullptr ? zip_error_strerror(&error) : "";
  zip_error_fini(&error);
  if (result == nullptr) {
    throw std::runtime_error(name + ": " + reason);
  }
  return result;
}

Source bufferSource(const std::string& name, const void* bytes, std::size_t size) {
  return {checked(name, [&](zip_error_t* error) { return zip_source_buffer_create(bytes, size, 0, error); }),
          zip_source_free};
}

// The archive takes a share of the source, which stays with the caller, too.
Archive openArchive(const std::string& name, const Source& source, int flags) {
  zip_source_keep(source.get());
  try {
    return {checked(name, [&](zip_error_t* error) { return zip_open_from_source(source.get(), flags, error); }),
            zip_discard};
  } catch (...) {
    zip_source_free(source.get());
    throw;
  }
}

void require(bool condition, const std::string& what) {
  if (!condition) {
    throw std::runtime_error(what);
  }
}

}  // namespace

std::string toZip(const std::vector<ArchiveEntry>& entries) {
  const std::string name = "zip archive";
  const Source whole = bufferSource(name, nullptr, 0);
  Archive archive = openArchive(name, whole, ZIP_CREATE | ZIP_TRUNCATE);
  for (const ArchiveEntry& entry : entries) {
    Source content = bufferSource(entry.path, entry.content.data(), entry.content.size());
    const zip_int64_t index = zip_file_add(archive.get(), entry.path.c_str(), content.get(), ZIP_FL_ENC_UTF_8);
    require(index >= 0, entry.path + ": " + zip_strerror(archive.get()));
    static_cast<void>(content.release());  // now the archive's
    zip_file_set_mtime(archive.get(), static_cast<zip_uint64_t>(index), kTimeOfFiles, 0);
  }
  require(zip_close(archive.get()) == 0, name + ": " + zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // closed
  require(zip_source_open(whole.get()) == 0 && zip_source_seek(whole.get(), 0, SEEK_END) == 0, name + ": no bytes");
  std::string bytes(static_cast<std::size_t>(zip_source_tell(whole.get())), '\0');
  zip_source_seek(whole.get(), 0, SEEK_SET);
  const zip_int64_t count = zip_source_read(whole.get(), bytes.data(), bytes.size());
  zip_source_close(whole.get());
  require(count == static_cast<zip_int64_t>(bytes.size()), name + ": cannot be read back");
  return bytes;
}

std::vector<ArchiveEntry> fromZip(const std::string& bytes, const std::string& source) {
  const Archive archive = openArchive(source, bufferSource(source, bytes.data(), bytes.size()), ZIP_RDONLY);
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

}  // namespace rubber_suspension::fmi
