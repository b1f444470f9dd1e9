// Writes and reads records as JSON files.
#include "campaign/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "campaign/manifest.h"
#include "element/refuse.h"
#include "io/output_files.h"
#include "io/sha256.h"
#include "log/new_file.h"

namespace rubber_suspension::campaign {
namespace {

using nlohmann::ordered_json;

namespace fs = std::filesystem;

const std::string kDigestKey = ",\"sha256\":\"";

// Appends a last member to the text of a record: the digest of all other members.
std::string withDigest(std::string text) {
  const std::string digest = io::sha256(text);
  text.pop_back();
  return text + kDigestKey + digest + "\"}\n";
}

ordered_json recordJson(const Record& record) {
  const Findings& findings = record.findings;
  ordered_json files = ordered_json::object();
  for (const auto& [name, content] : record.files) {
    files[name] = {{"size", content.size}, {"sha256", content.sha256}};
  }
  ordered_json evidence = {{"effects", findings.effects}, {"changes", findings.changes}};
  if (findings.verdict) {
    evidence["verdict"] = toString(*findings.verdict);
  }
  return {{"schema", "rubber_suspension/job_record/4"},
          {"id", record.id},
          {"version", record.version},
          {"status", record.failed() ? "failed" : "done"},
          {"error", record.error},
          {"values", record.values},
          {"evidence", evidence},
          {"files", files},
          {"seconds", record.seconds}};
}

// Throws std::exception if the text is not a complete record. The depth is limited because copying JSON is recursive.
Record recordFromText(const std::string& text) {
  static constexpr int kDeepest = 16;
  const auto json = ordered_json::parse(text, [](int depth, ordered_json::parse_event_t, ordered_json&) {
    element::refuseIf<std::runtime_error>(depth > kDeepest, "the record is nested deeper than {} levels", kDeepest);
    return true;
  });
  const ordered_json& values = json.at("values");
  const bool nested =
      std::any_of(values.begin(), values.end(), [](const auto& value) { return value.is_structured(); });
  element::refuseIf<std::runtime_error>(!values.is_object() || nested, "values: is not a map of numbers and texts");
  Record record{json.at("id"), json.at("version"), json.at("error"), values};
  const ordered_json& evidence = json.at("evidence");
  if (evidence.contains("verdict")) {
    record.findings.verdict = diagnosis::verdictOf(evidence["verdict"].get<std::string>());
  }
  evidence.at("effects").get_to(record.findings.effects);
  evidence.at("changes").get_to(record.findings.changes);
  for (const auto& [name, content] : json.at("files").items()) {
    record.files[name] = {content.at("sha256"), content.at("size")};
  }
  json.at("seconds").get_to(record.seconds);
  return record;
}

// Returns the kind of an entry that is not a regular file. Returns "" for a regular file, or if there is no entry.
std::string otherKind(const std::string& path) {
  std::error_code unknown;  // any error is reported when reading fails
  const fs::file_status status = fs::status(path, unknown);
  if (!fs::is_directory(status) && !fs::is_other(status)) {
    return "";
  }
  return fs::is_directory(status) ? "a folder" : (fs::is_fifo(status) ? "a pipe" : "a device or socket");
}

// Throws std::runtime_error if the record belongs to another job or version, or if it or its report has changed.
void check(const Record& record, const std::string& text, const std::string& folder, const std::string& id,
           const std::string& version, FileCheck files) {
  using Error = std::runtime_error;
  element::refuseIf<Error>(record.id != id, "the record belongs to another job");
  element::refuseIf<Error>(record.version != version, "the record was written by version {}, not {}", record.version,
                           version);
  const std::size_t digest = text.rfind(kDigestKey);
  element::refuseIf<Error>(digest == std::string::npos || withDigest(text.substr(0, digest) + "}") != text,
                           "the record was changed after it was written");
  for (const auto& [name, content] : record.files) {
    const std::string path = folder + "/" + reportFolder(record.id) + "/" + name;
    std::error_code missing;
    const std::uintmax_t found = fs::file_size(path, missing);
    element::refuseIf<Error>(bool(missing), "{} is missing", path);
    element::refuseIf<Error>(found != content.size, "{} has {} bytes instead of {}", path, found, content.size);
    element::refuseIf<Error>(files == FileCheck::digests && io::hashFile(path).sha256 != content.sha256,
                             "{} was changed after it was written", path);
  }
}

}  // namespace

std::string reportPath(const Record& record) {
  for (const char* name : {"report.html", "report.json", "identification.json", "force.csv"}) {
    if (record.files.count(name) != 0) {
      return reportFolder(record.id) + "/" + name;
    }
  }
  return "";
}

void writeRecord(const Record& record, const std::string& folder) {
  const std::string path = recordPath(folder, record.id);
  io::makeFolder(fs::path(path).parent_path());
  if (!otherKind(path).empty()) {
    fs::rename(path, path + ".no_record");
  }
  // An error may quote bytes of a file, which need not be valid UTF-8.
  log::writeNewFile(path, withDigest(recordJson(record).dump(-1, ' ', false, ordered_json::error_handler_t::replace)));
}

FoundRecord findRecord(const std::string& folder, const std::string& id, const std::string& version, FileCheck files) {
  constexpr std::uintmax_t kLargest = std::uintmax_t{16} << 20;  // bytes; far more than ten thousand values need
  const std::string path = recordPath(folder, id);
  if (const std::string kind = otherKind(path); !kind.empty()) {  // reading a pipe would block
    return {std::nullopt, path + ": is " + kind + "; accepted: a record"};
  }
  std::error_code unknown;  // any error is reported when opening fails
  if (const std::uintmax_t size = fs::file_size(path, unknown); !unknown && size > kLargest) {
    return {std::nullopt, fmt::format("{}: has {} bytes; accepted: a record of at most {}", path, size, kLargest)};
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return {std::nullopt, errno == ENOENT ? "" : path + ": cannot be read"};
  }
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  try {
    Record record = recordFromText(text);
    check(record, text, folder, id, version, files);
    return {std::move(record), ""};
  } catch (const ordered_json::exception&) {
    return {std::nullopt, path + ": is not a complete record"};
  } catch (const std::exception& error) {
    return {std::nullopt, path + ": " + error.what()};
  }
}

}  // namespace rubber_suspension::campaign
