// Computes ids of jobs, and writes and reads the manifest as JSON lines.
#include "campaign/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string_view>
#include <unordered_set>

#include "element/each.h"
#include "element/refuse.h"
#include "element/suggestion.h"
#include "log/new_file.h"

namespace rubber_suspension::campaign {
namespace {

using nlohmann::ordered_json;

template <class Enum>
void readEnum(const nlohmann::json& json, Enum& value, const std::vector<std::string>& names) {
  const auto name = json.get<std::string>();
  const auto found = std::find(names.begin(), names.end(), name);
  element::refuseIf(found == names.end(), "'{}' is unknown", name);
  value = static_cast<Enum>(found - names.begin());
}

// Calls visit(key, pointer to member, true if every manifest contains the key) for all members except the options.
template <class Visit>
void forEachMember(Visit visit) {
  visit("id", &Job::id, true);
  visit("group", &Job::group, true);
  visit("type", &Job::type, true);
  visit("test_piece", &Job::test_piece, true);
  visit("component", &Job::component, true);
  visit("config", &Job::config, true);
  visit("logs", &Job::logs, true);
  visit("test_rig", &Job::test_rig, false);
  visit("hold_out", &Job::hold_out, false);
  visit("specification", &Job::specification, false);
  visit("command", &Job::command, true);
}

// Returns the digest of the contents and the name of each file.
ordered_json filesJson(const std::vector<std::size_t>& files, const std::vector<InputFile>& inputs) {
  return element::each(files, [&](std::size_t file) -> ordered_json {
    return {inputs.at(file).content.sha256, std::filesystem::path(inputs.at(file).path).stem().string()};
  });
}

const char* const kManifestSchema = "rubber_suspension/campaign/1";

// The first two digits of the id select one of 256 folders, so that no folder has too many records.
constexpr std::size_t kPrefix = 2;

std::string split(const std::string& id) { return id.substr(0, kPrefix) + "/" + id.substr(kPrefix); }

// Throws std::invalid_argument if a job has no logs, no valid id, or an input that is not in the manifest.
void checkJob(const Job& job, std::size_t inputs) {
  std::vector<std::size_t> files = job.logs;
  files.insert(files.end(), job.hold_out.begin(), job.hold_out.end());
  files.push_back(job.config);
  const std::size_t last = *std::max_element(files.begin(), files.end());
  element::refuseIf(last >= inputs, "a job refers to input {}, but the manifest has only {} inputs", last, inputs);
  const bool has_id = job.id.size() == 64 && job.id.find_first_not_of("0123456789abcdef") == std::string::npos;
  element::refuseIf(!has_id || job.logs.empty(), "a job has no logs, or its id is not a SHA-256 digest");
}

Manifest readLines(const std::function<nlohmann::json()>& next) {
  Manifest manifest;
  const nlohmann::json header = next();
  element::refuseIf(header.at("schema") != kManifestSchema, "the value of 'schema' does not name a manifest");
  header.at("version").get_to(manifest.version);
  const auto inputs = header.at("inputs").get<std::size_t>();
  for (std::size_t i = 0; i < inputs; ++i) {
    const nlohmann::json line = next();
    manifest.inputs.push_back({line.at("path"), {line.at("sha256"), line.at("size")}});
  }
  const auto jobs = header.at("jobs").get<std::size_t>();
  for (std::size_t i = 0; i < jobs; ++i) {
    manifest.jobs.push_back(next());
    checkJob(manifest.jobs.back(), inputs);
  }
  return manifest;
}

}  // namespace

void to_json(ordered_json& json, Command command) { json = toString(command); }
void to_json(ordered_json& json, Reports reports) { json = toString(reports); }
void from_json(const nlohmann::json& json, Command& command) { readEnum(json, command, kCommands); }
void from_json(const nlohmann::json& json, Reports& reports) { readEnum(json, reports, kReports); }

void to_json(ordered_json& json, const JobOptions& options) {
  json = {{"reports", options.reports}};
  forEachOption([&, usual = JobOptions()](const char* key, auto option) {
    if (options.*option != usual.*option) {
      json[key] = options.*option;
    }
  });
}

void from_json(const nlohmann::json& json, JobOptions& options) {
  std::vector<std::string> known;
  forEachOption([&](const char* key, auto option) {
    known.emplace_back(key);
    if (json.contains(key)) {
      json.at(key).get_to(options.*option);
    }
  });
  for (const auto& entry : json.items()) {  // options of another version may be unknown and must not be ignored
    element::refuseIf(std::find(known.begin(), known.end(), entry.key()) == known.end(), "'{}' is unknown{}",
                      entry.key(), element::didYouMean(entry.key(), known));
  }
}

std::string nameOf(const Job& job) { return job.group + " " + job.test_piece + " (" + job.id.substr(0, 12) + ")"; }

std::string jobId(const Job& job, const std::vector<InputFile>& inputs, const std::string& version) {
  const ordered_json json = {{"version", version},
                             {"command", job.command},
                             {"component", job.component},
                             {"config", inputs.at(job.config).content.sha256},
                             {"logs", filesJson(job.logs, inputs)},
                             {"hold_out", filesJson(job.hold_out, inputs)},
                             {"specification", job.specification},
                             {"options", job.options}};
  return io::sha256(json.dump());
}

void to_json(ordered_json& json, const Job& job) {
  forEachMember([&, empty = Job()](const char* key, auto member, bool always) {
    if (always || job.*member != empty.*member) {
      json[key] = job.*member;
    }
  });
  json["options"] = job.options;
}

void from_json(const nlohmann::json& json, Job& job) {
  forEachMember([&](const char* key, auto member, bool always) {
    if (always || json.contains(key)) {
      json.at(key).get_to(job.*member);
    }
  });
  json.at("options").get_to(job.options);
}

std::vector<std::size_t> Manifest::distinctJobs() const {
  std::unordered_set<std::string_view> seen;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (seen.insert(jobs[i].id).second) {
      result.push_back(i);
    }
  }
  return result;
}

std::string recordPath(const std::string& folder, const std::string& id) {
  return folder + "/results/" + split(id) + ".json";
}

std::string reportFolder(const std::string& id) { return "reports/" + split(id); }

void writeManifest(const Manifest& manifest, const std::string& folder) {
  log::NewFile file(manifestPath(folder));
  file.line(ordered_json({{"schema", kManifestSchema},
                          {"version", manifest.version},
                          {"inputs", manifest.inputs.size()},
                          {"jobs", manifest.jobs.size()}})
                .dump());
  for (const InputFile& input : manifest.inputs) {
    file.line(
        ordered_json({{"path", input.path}, {"sha256", input.content.sha256}, {"size", input.content.size}}).dump());
  }
  for (const Job& job : manifest.jobs) {
    file.line(ordered_json(job).dump());
  }
  file.commit();
}

Manifest readManifest(const std::string& folder) {
  const std::string path = manifestPath(folder);
  std::ifstream file(path, std::ios::binary);
  element::refuseIf<std::runtime_error>(!file, "{}: cannot be read: {}; accepted: a folder that `campaign make` made",
                                        path, std::strerror(errno));
  std::size_t number = 0;
  const auto next = [&] {
    ++number;
    std::string line;
    element::refuseIf(!std::getline(file, line) || file.eof(), "the file is cut off");
    return nlohmann::json::parse(line);
  };
  try {
    return readLines(next);
  } catch (const std::exception& error) {
    throw std::runtime_error(
        fmt::format("{}:{}: {}; accepted: a manifest as `campaign make` writes it", path, number, error.what()));
  }
}

}  // namespace rubber_suspension::campaign
