// Zip archives in memory, by libzip.
#include "fmi/archive.h"

#include <zip.h>

#include <memory>
#include <stdexcept>

namespace rubber_suspension::fmi {
namespace {

// 2 January 1980, since zip has no earlier year and keeps local time: the same bytes today and tomorrow.
constexpr time_t kTimeOfFiles = 315619200;

struct ArchiveDiscard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Archive = std::unique_ptr<zip_t, ArchiveDiscard>;

struct SourceFree {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, SourceFree>;

[[noreturn]] void fail(const std::string& what, zip_error_t& error) {
  const std::string reason = zip_error_strerror(&error);
  zip_error_fini(&error);
  throw std::runtime_error(what + ": " + reason);
}

Source bufferSource(const void* bytes, std::size_t size) {
  zip_error_t error;
  zip_error_init(&error);
  Source source(zip_source_buffer_create(bytes, size, 0, &error));
  if (!source) {
    fail("zip archive", error);
  }
  return source;
}

// The archive takes a share of the source, which stays with the caller, too.
Archive openArchive(const Source& source, int flags, const std::string& name) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_keep(source.get());
  Archive archive(zip_open_from_source(source.get(), flags, &error));
  if (!archive) {
    zip_source_free(source.get());
    fail(name, error);
  }
  return archive;
}

void addEntry(const Archive& archive, const ArchiveEntry& entry) {
  Source content = bufferSource(entry.content.data(), entry.content.size());
  const zip_int64_t index = zip_file_add(archive.get(), entry.path.c_str(), content.get(), ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    throw std::runtime_error(entry.path + ": " + zip_strerror(archive.get()));
  }
  static_cast<void>(content.release());  // now the archive's
  zip_file_set_mtime(archive.get(), static_cast<zip_uint64_t>(index), kTimeOfFiles, 0);
}

std::string bytesOf(const Source& source) {
  if (zip_source_open(source.get()) != 0 || zip_source_seek(source.get(), 0, SEEK_END) != 0) {
    throw std::runtime_error("zip archive: cannot be read back");
  }
  std::string bytes(static_cast<std::size_t>(zip_source_tell(source.get())), '\0');
  zip_source_seek(source.get(), 0, SEEK_SET);
  const zip_int64_t count = zip_source_read(source.get(), bytes.data(), bytes.size());
  zip_source_close(source.get());
  if (count != static_cast<zip_int64_t>(bytes.size())) {
    throw std::runtime_error("zip archive: cannot be read back");
  }
  return bytes;
}

std::string contentOf(const Archive& archive, zip_uint64_t index, const zip_stat_t& status, const std::string& name) {
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen_index(archive.get(), index, 0), zip_fclose);
  std::string content(status.size, '\0');
  if (!file || zip_fread(file.get(), content.data(), status.size) != static_cast<zip_int64_t>(status.size)) {
    throw std::runtime_error(name + ": " + status.name + " cannot be read");
  }
  return content;
}

}  // namespace

std::string toZip(const std::vector<ArchiveEntry>& entries) {
  const Source bytes = bufferSource(nullptr, 0);
  Archive archive = openArchive(bytes, ZIP_CREATE | ZIP_TRUNCATE, "zip archive");
  for (const ArchiveEntry& entry : entries) {
    addEntry(archive, entry);
  }
  if (zip_close(archive.get()) != 0) {
    throw std::runtime_error(std::string("zip archive: ") + zip_strerror(archive.get()));
  }
  static_cast<void>(archive.release());  // closed
  return bytesOf(bytes);
}

std::vector<ArchiveEntry> fromZip(const std::string& bytes, const std::string& source) {
  const Archive archive = openArchive(bufferSource(bytes.data(), bytes.size()), ZIP_RDONLY, source);
  std::vector<ArchiveEntry> entries;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const auto index = static_cast<zip_uint64_t>(i);
    zip_stat_t status;
    if (zip_stat_index(archive.get(), index, 0, &status) != 0) {
      throw std::runtime_error(source + ": " + zip_strerror(archive.get()));
    }
    const std::string path = status.name;
    if (path.empty() || path.back() != '/') {
      entries.push_back({path, contentOf(archive, index, status, source)});
    }
  }
  return entries;
}

}  // namespace rubber_suspension::fmi
