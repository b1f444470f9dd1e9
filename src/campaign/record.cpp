// Records as JSON files.
#include "campaign/record.h"

#include <sys/stat.h>

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

const char* const kRecordSchema = "rubber_suspension/job_record/3";

ordered_json findingsJson(const Findings& findings) {
  ordered_json json = {{"effects", findings.effects}, {"changes", findings.changes}};
  if (findings.verdict) {
    json["verdict"] = toString(*findings.verdict);
  }
  return json;
}

Findings findingsFromJson(const ordered_json& json) {
  Findings findings;
  json.at("effects").get_to(findings.effects);
  json.at("changes").get_to(findings.changes);
  if (json.contains("verdict")) {
    findings.verdict = diagnosis::verdictOf(json.at("verdict").get<std::string>());
  }
  return findings;
}

ordered_json recordJson(const Record& record) {
  return {{"schema", kRecordSchema},
          {"id", record.id},
          {"version", record.version},
          {"status", record.failed() ? "failed" : "done"},
          {"error", record.error},
          {"values", record.values},
          {"evidence", findingsJson(record.findings)},
          {"files", record.files},
          {"seconds", record.seconds}};
}

const std::string kDigestKey = ",\"sha256\":\"";

// The text of a record as it is written: its last member is the digest of all before.
std::string withDigest(std::string text) {
  const std::string digest = io::sha256(text);
  text.pop_back();
  return text + kDigestKey + digest + "\"}\n";
}

bool holdsItsDigest(const std::string& text) {
  const std::size_t at = text.rfind(kDigestKey);
  return at != std::string::npos && withDigest(text.substr(0, at) + "}") == text;
}

// Kind of the entry in a record's place that is no regular file; nothing where there is none.
std::string otherKind(const std::string& path) {
  std::error_code unknown;  // reading it says why
  switch (std::filesystem::status(path, unknown).type()) {
    case std::filesystem::file_type::directory:
      return "a folder";
    case std::filesystem::file_type::fifo:
      return "a pipe";
    case std::filesystem::file_type::character:
    case std::filesystem::file_type::block:
    case std::filesystem::file_type::socket:
      return "a device or socket";
    default:
      return "";
  }
}

// Copies of JSON call themselves for each level.
ordered_json parsedShallow(const std::string& text) {
  static constexpr int kDeepest = 16;
  return ordered_json::parse(text, [](int depth, ordered_json::parse_event_t, ordered_json&) {
    element::refuseIf<std::runtime_error>(depth > kDeepest, "nested deeper than {}", kDeepest);
    return true;
  });
}

// Throws std::exception for what is no complete record.
Record recordFromJson(const ordered_json& json) {
  Record record;
  json.at("id").get_to(record.id);
  json.at("version").get_to(record.version);
  json.at("error").get_to(record.error);
  record.values = json.at("values");
  record.findings = findingsFromJson(json.at("evidence"));
  json.at("files").get_to(record.files);
  json.at("seconds").get_to(record.seconds);
  const auto nested = [](const ordered_json& value) { return value.is_structured(); };
  element::refuseIf<std::runtime_error>(
      !record.values.is_object() || std::any_of(record.values.begin(), record.values.end(), nested),
      "values: accepted: numbers and texts by name");
  return record;
}

// Throws std::runtime_error for a file of the report that is not there as it was written.
void requireFiles(const std::string& folder, const Record& record) {
  for (const auto& [name, size] : record.files) {
    const std::string path = folder + "/" + reportFolder(record.id) + "/" + name;
    struct stat status {};
    element::refuseIf<std::runtime_error>(stat(path.c_str(), &status) != 0, "{} is missing", path);
    element::refuseIf<std::runtime_error>(static_cast<std::uint64_t>(status.st_size) != size, "{} has {} bytes, not {}",
                                          path, status.st_size, size);
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
  io::makeFolder(std::filesystem::path(path).parent_path());
  if (!otherKind(path).empty()) {
    std::filesystem::rename(path, path + ".no_record");
  }
  // An error may quote a file's bytes, which need not be UTF-8.
  log::writeNewFile(path, withDigest(recordJson(record).dump(-1, ' ', false, ordered_json::error_handler_t::replace)));
}

FoundRecord findRecord(const std::string& folder, const std::string& id, const std::string& version, bool files) {
  const std::string path = recordPath(folder, id);
  if (const std::string kind = otherKind(path); !kind.empty()) {  // a pipe would have its reader wait
    return {std::nullopt, path + ": is " + kind + ", not a record"};
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return {std::nullopt, errno == ENOENT ? "" : path + ": cannot be read"};
  }
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  try {
    Record record = recordFromJson(parsedShallow(text));
    element::refuseIf<std::runtime_error>(record.id != id, "the record of another job");
    element::refuseIf<std::runtime_error>(record.version != version, "of version {}, not {}", record.version, version);
    element::refuseIf<std::runtime_error>(!holdsItsDigest(text), "was changed since it was written");
    if (files) {
      requireFiles(folder, record);
    }
    return {std::move(record), ""};
  } catch (const nlohmann::json::exception&) {
    return {std::nullopt, path + ": cut off, or no record"};
  } catch (const std::exception& error) {
    return {std::nullopt, path + ": " + error.what()};
  }
}

}  // namespace rubber_suspension::campaign
