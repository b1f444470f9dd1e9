// Records as JSON files.
#include "campaign/record.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "campaign/manifest.h"
#include "log/new_file.h"

namespace rubber_suspension::campaign {
namespace {

using nlohmann::ordered_json;

const char* const kRecordSchema = "rubber_suspension/job_record/1";

ordered_json recordJson(const Record& record) {
  return {{"schema", kRecordSchema},     {"id", record.id},
          {"version", record.version},   {"status", record.failed() ? "failed" : "done"},
          {"error", record.error},       {"values", record.values},
          {"evidence", record.evidence}, {"files", record.files},
          {"seconds", record.seconds}};
}

// Copies of JSON call themselves for each level.
ordered_json parsedShallow(const std::string& text) {
  static constexpr int kDeepest = 16;
  return ordered_json::parse(text, [](int depth, ordered_json::parse_event_t, ordered_json&) {
    if (depth > kDeepest) {
      throw std::runtime_error(fmt::format("nested deeper than {}", kDeepest));
    }
    return true;
  });
}

// Numbers and texts by name.
void requireValues(const ordered_json& values) {
  const bool flat = values.is_object() && std::all_of(values.begin(), values.end(),
                                                      [](const ordered_json& value) { return !value.is_structured(); });
  if (!flat) {
    throw std::runtime_error("values: accepted: numbers and texts by name");
  }
}

// What the statistics of a fleet take, as execute.cpp writes it.
void requireEvidence(const ordered_json& evidence) {
  const auto is = [&](const char* key, bool (ordered_json::*of_type)() const noexcept) {
    return !evidence.contains(key) || (evidence.at(key).*of_type)();
  };
  const bool fits = evidence.is_object() && is("verdict", &ordered_json::is_string) &&
                    is("effects", &ordered_json::is_array) && is("explanations", &ordered_json::is_array) &&
                    is("ratios", &ordered_json::is_object) && is("ratios_by_log", &ordered_json::is_array) &&
                    is("parameters", &ordered_json::is_array);
  if (!fits) {
    throw std::runtime_error("evidence: of another form; accepted: as campaign run writes it");
  }
}

// Throws std::runtime_error or nlohmann::json::exception for what is no complete record.
Record recordFromJson(const ordered_json& json) {
  Record record;
  record.id = json.at("id").get<std::string>();
  record.version = json.at("version").get<std::string>();
  record.error = json.at("error").get<std::string>();
  record.values = json.at("values").get<ordered_json>();
  record.evidence = json.at("evidence").get<ordered_json>();
  if (!record.failed() || !record.values.is_null() || !record.evidence.is_null()) {  // a job that failed has neither
    requireValues(record.values);
    requireEvidence(record.evidence);
  }
  record.files = json.at("files").get<std::map<std::string, std::uint64_t>>();
  record.seconds = json.at("seconds").get<double>();
  return record;
}

FoundRecord broken(const std::string& path, const std::string& reason) {
  return {FoundRecord::State::broken, path + ": " + reason, {}};
}

// The first file of the report that is not there as it was written; "" where all are.
std::string damagedFile(const std::string& folder, const Record& record) {
  for (const auto& [name, size] : record.files) {
    const std::string path = folder + "/" + reportFolder(record.id) + "/" + name;
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) {
      return path + " is missing";
    }
    if (static_cast<std::uint64_t>(status.st_size) != size) {
      return fmt::format("{} has {} bytes, not {}", path, status.st_size, size);
    }
  }
  return "";
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
  std::error_code failure;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), failure);
  if (failure) {
    throw std::runtime_error(path + ": its folder cannot be made: " + failure.message());
  }
  // An error may quote a file's bytes, which need not be UTF-8.
  log::writeNewFile(path, recordJson(record).dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

FoundRecord findRecord(const std::string& folder, const std::string& id, const std::string& version, bool files) {
  const std::string path = recordPath(folder, id);
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return errno == ENOENT ? FoundRecord{} : broken(path, "cannot be read");
  }
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  FoundRecord found;
  try {
    found.record = recordFromJson(parsedShallow(text));
  } catch (const nlohmann::json::exception&) {
    return broken(path, "cut off, or no record");
  } catch (const std::runtime_error& error) {
    return broken(path, error.what());
  }
  if (found.record.id != id) {
    return broken(path, "the record of another job");
  }
  if (found.record.version != version) {
    return broken(path, fmt::format("of version {}, not {}", found.record.version, version));
  }
  const std::string damaged = files ? damagedFile(folder, found.record) : "";
  if (!damaged.empty()) {
    return broken(path, damaged);
  }
  found.state = FoundRecord::State::good;
  return found;
}

}  // namespace rubber_suspension::campaign
