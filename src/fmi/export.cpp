// Writes the files of an FMU into an archive.
#include "fmi/export.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <zip.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>

#include "element/refuse.h"
#include "fmi/runtime/embedded.h"
#include "fmi/runtime/saved_state.h"

namespace rubber_suspension::fmi {
namespace {

constexpr const char* kTool = "rubber_suspension " RUBBER_SUSPENSION_VERSION;
constexpr const char kUnreadable[] = "{}: cannot be read; accepted: the file that was installed with this program";

// 2 January 1980. A fixed date makes the bytes reproducible. Zip uses local time and no year before 1980.
constexpr time_t kTimeOfFiles = 315619200;

void require(bool done, const std::string& name, const char* reason) {
  element::refuseIf<std::runtime_error>(!done, "{}: {}", name, reason);
}

std::string readFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  element::refuseIf<std::runtime_error>(content.empty(), kUnreadable, path);
  return content;
}

// Returns a GUID that depends on the content, in the form of a UUID, which some importers expect.
std::string guidOf(const std::string& content) {
  const std::uint64_t high = fingerprintOf(content);
  const std::uint64_t low = fingerprintOf(content + "+");
  return fmt::format("{{{:08x}-{:04x}-{:04x}-{:04x}-{:012x}}}", high >> 32, (high >> 16) & 0xffff, high & 0xffff,
                     low >> 48, low & 0xffffffffffff);
}

// Returns the binary at a path, with the text of the component written into its EmbeddedBlock.
std::string binaryWith(const std::string& text, const std::string& path) {
  std::string binary = readFile(path);
  const std::string marker(RUBBER_SUSPENSION_BLOCK_MARKER, sizeof(RUBBER_SUSPENSION_BLOCK_MARKER));
  const std::size_t start = binary.find(marker);
  const bool once = start != std::string::npos && binary.find(marker, start + 1) == std::string::npos;
  element::refuseIf<std::runtime_error>(!once || start + sizeof(EmbeddedBlock) > binary.size(),
                                        "{}: has no block for a component; accepted: the FMU binary of this version",
                                        path);
  element::refuseIf<std::runtime_error>(
      text.size() > kCapacity, "{}: the component needs {} bytes; accepted: at most {}", path, text.size(), kCapacity);
  const std::uint64_t size = text.size();
  std::memcpy(&binary[start + offsetof(EmbeddedBlock, size)], &size, sizeof(size));
  text.copy(&binary[start + offsetof(EmbeddedBlock, text)], text.size());
  return binary;
}

// Returns a header with the text of the component as string literals. Compilers need to accept only 65536 bytes in one
// literal, so the text is split into pieces, which the compiler joins.
std::string componentHeader(const std::string& text) {
  constexpr std::size_t kPiece = 8192;
  std::string header = "#pragma once\n#define RUBBER_SUSPENSION_COMPONENT_TEXT";
  for (std::size_t begin = 0; begin < text.size(); begin += kPiece) {
    header += " \\\n  R\"json(" + text.substr(begin, kPiece) + ")json\"";
  }
  return header + "\n";
}

// Adds the sources, sorted because the order of the files in a folder is arbitrary.
void addSources(std::vector<ArchiveEntry>& entries, const ComponentData& data, const std::string& folder) {
  std::set<std::string> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
    if (entry.is_regular_file()) {
      files.insert(entry.path().lexically_relative(folder).generic_string());
    }
  }
  element::refuseIf<std::runtime_error>(files.empty(), kUnreadable, folder);
  for (const std::string& file : files) {
    const std::string head = file == "CMakeLists.txt" ? "set(model_identifier " + data.name + ")\n" : "";
    entries.push_back({"sources/" + file, head + readFile(folder + "/" + file)});
  }
  entries.push_back({"sources/component_text.h", componentHeader(toJson(data))});
}

}  // namespace

std::string toZip(const std::vector<ArchiveEntry>& entries) {
  const std::string name = "zip archive";
  const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> whole(zip_source_buffer_create(nullptr, 0, 0, nullptr),
                                                                     zip_source_free);
  std::unique_ptr<zip_t, void (*)(zip_t*)> archive(
      zip_open_from_source(whole.get(), ZIP_CREATE | ZIP_TRUNCATE, nullptr), zip_discard);
  require(archive != nullptr, name, "cannot be created");
  zip_source_keep(whole.get());  // because zip_close() also releases it
  for (const ArchiveEntry& entry : entries) {
    zip_source_t* const content = zip_source_buffer(archive.get(), entry.content.data(), entry.content.size(), 0);
    const zip_int64_t index = zip_file_add(archive.get(), entry.path.c_str(), content, ZIP_FL_ENC_UTF_8);
    if (index < 0) {  // on success the archive owns the content
      zip_source_free(content);
    }
    require(index >= 0, entry.path, zip_strerror(archive.get()));
    zip_file_set_mtime(archive.get(), static_cast<zip_uint64_t>(index), kTimeOfFiles, 0);
  }
  require(zip_close(archive.get()) == 0, name, zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // zip_close() has freed it
  zip_stat_t status;
  require(zip_source_stat(whole.get(), &status) == 0 && zip_source_open(whole.get()) == 0, name,
          "cannot be opened again");
  std::string bytes(status.size, '\0');
  const zip_int64_t count = zip_source_read(whole.get(), bytes.data(), bytes.size());
  zip_source_close(whole.get());
  require(count == static_cast<zip_int64_t>(bytes.size()), name, "cannot be read back");
  return bytes;
}

FmuParts installedParts() {
  Dl_info info{};
  element::refuseIf<std::runtime_error>(dladdr(reinterpret_cast<const void*>(&installedParts), &info) == 0,
                                        "the folder of this program is unknown");
  const std::filesystem::path folder = std::filesystem::path(info.dli_fname).parent_path();
  const std::filesystem::path windows = folder / "rubber_suspension_fmu.dll";
  return {folder / "rubber_suspension_fmu.so", folder / "rubber_suspension_fmu_sources",
          std::filesystem::exists(windows) ? windows.string() : ""};
}

ComponentData dataOf(const io::ComponentDescription& description) {
  ComponentData data;
  data.name = description.name;
  if (description.six) {
    data.six = description.six->makeComponent().laws();
    for (auto& elements : data.six->elements) {
      elements = completed(elements);
    }
  } else if (description.specification().curve() == nullptr) {
    data.model = description.model();
    data.specification = description.specification();
  }  // otherwise the elements are estimated from a curve, which cannot be a variable, and stored below
  if (!description.six && data.model == estimation::Model::elements) {
    data.elements = completed(description.elements());
  }
  data.add = completed(description.add);
  if (description.temperature) {
    data.temperature = completed({*description.temperature});
  }
  data.guid = guidOf(toJson(data) + kTool);
  return data;
}

std::vector<ArchiveEntry> fmuFiles(const io::ComponentDescription& description, Version version,
                                   const FmuParts& parts) {
  const ComponentData data = dataOf(description);
  const bool is_2 = version == Version::fmi2;
  const std::string text = toJson(data);
  std::vector<ArchiveEntry> files = {
      {"modelDescription.xml", modelDescription(data, version, kTool)},
      {fmt::format("binaries/{}/{}.so", is_2 ? "linux64" : "x86_64-linux", data.name), binaryWith(text, parts.binary)},
      {"resources/component.yaml", io::toYaml({description})}};
  if (!parts.windows_binary.empty()) {
    files.push_back({fmt::format("binaries/{}/{}.dll", is_2 ? "win64" : "x86_64-windows", data.name),
                     binaryWith(text, parts.windows_binary)});
  }
  addSources(files, data, parts.sources);
  return files;
}

}  // namespace rubber_suspension::fmi
