// Jobs, their ids, and the manifest as JSON lines.
#include "campaign/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
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

constexpr std::array kCommands = {"diagnose", "estimate", "replay"};
constexpr std::array kReports = {"none", "data", "full"};

template <class Enum, std::size_t Size>
std::optional<Enum> fromName(const std::array<const char*, Size>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::make_optional(static_cast<Enum>(found - names.begin()));
}

template <class Enum>
Enum require(const std::optional<Enum>& value, const std::string& name) {
  return value ? *value : throw std::invalid_argument("'" + name + "' is unknown");
}

// Content and, of a log, its name.
ordered_json filesJson(const std::vector<std::size_t>& files, const std::vector<InputFile>& inputs) {
  return element::each(files, [&](std::size_t file) -> ordered_json {
    return {inputs.at(file).content.sha256, std::filesystem::path(inputs.at(file).path).stem().string()};
  });
}

ordered_json optionsJson(const JobOptions& options) {
  ordered_json json = {{"reports", toString(options.reports)}};
  forEachOption([&, usual = JobOptions()](const char* key, auto option) {
    if (options.*option != usual.*option) {
      json[key] = options.*option;
    }
  });
  return json;
}

JobOptions optionsFromJson(const nlohmann::json& json) {
  const std::vector<std::string> known = optionKeys();
  for (const auto& entry : json.items()) {  // a manifest of another version may have others, which must not go unheard
    element::refuseIf(std::find(known.begin(), known.end(), entry.key()) == known.end(), "'{}' is unknown{}",
                      entry.key(), element::didYouMean(entry.key(), known));
  }
  JobOptions options;
  const std::string reports = json.value("reports", toString(options.reports));
  options.reports = require(reportsFromString(reports), reports);
  forEachOption([&](const char* key, auto option) {
    if (json.contains(key)) {
      json.at(key).get_to(options.*option);
    }
  });
  return options;
}

// Calls visit(key, pointer to member, whether it stands in every manifest) for all but command and options.
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
}

const char* const kManifestSchema = "rubber_suspension/campaign/1";

// Two letters of the id make a folder each, so that none holds more than some hundred entries.
constexpr std::size_t kPrefix = 2;

std::string split(const std::string& id) { return id.substr(0, kPrefix) + "/" + id.substr(kPrefix); }

class LineReader {
 public:
  explicit LineReader(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    if (!file_) {
      throw std::runtime_error(fmt::format("{}: cannot be read: {}; accepted: a folder that `campaign make` made", path,
                                           std::strerror(errno)));
    }
  }

  nlohmann::json next() {
    ++number_;
    std::string line;
    element::refuseIf(!std::getline(file_, line) || file_.eof(), "the file is cut off");
    return nlohmann::json::parse(line);
  }

  [[noreturn]] void refuse(const std::string& problem) const {
    throw std::runtime_error(
        fmt::format("{}:{}: {}; accepted: a manifest as `campaign make` writes it", path_, number_, problem));
  }

 private:
  std::string path_;
  std::ifstream file_;
  std::size_t number_ = 0;
};

bool isId(const std::string& id) {
  return id.size() == 64 && id.find_first_not_of("0123456789abcdef") == std::string::npos;
}

// Throws std::invalid_argument where a job names what is not there.
void checkJob(const Job& job, std::size_t inputs) {
  std::vector<std::size_t> files = job.logs;
  files.insert(files.end(), job.hold_out.begin(), job.hold_out.end());
  files.push_back(job.config);
  const std::size_t last = *std::max_element(files.begin(), files.end());
  element::refuseIf(last >= inputs, "input {} is not among the {} inputs", last, inputs);
  element::refuseIf(!isId(job.id) || job.logs.empty(), "a job without id or logs");
}

Manifest readLines(LineReader& lines) {
  Manifest manifest;
  const nlohmann::json header = lines.next();
  element::refuseIf(header.at("schema") != kManifestSchema, "another schema");
  header.at("version").get_to(manifest.version);
  const auto inputs = header.at("inputs").get<std::size_t>();
  for (std::size_t i = 0; i < inputs; ++i) {
    const nlohmann::json line = lines.next();
    manifest.inputs.push_back({line.at("path"), {line.at("sha256"), line.at("size")}});
  }
  const auto jobs = header.at("jobs").get<std::size_t>();
  for (std::size_t i = 0; i < jobs; ++i) {
    manifest.jobs.push_back(jobFromJson(lines.next()));
    checkJob(manifest.jobs.back(), inputs);
  }
  return manifest;
}

}  // namespace

std::string toString(Command command) { return kCommands.at(static_cast<std::size_t>(command)); }

std::optional<Command> commandFromString(const std::string& name) { return fromName<Command>(kCommands, name); }

std::string toString(Reports reports) { return kReports.at(static_cast<std::size_t>(reports)); }

std::optional<Reports> reportsFromString(const std::string& name) { return fromName<Reports>(kReports, name); }

std::vector<std::string> optionKeys() {
  std::vector<std::string> keys = {"reports"};
  forEachOption([&](const char* key, auto /*option*/) { keys.emplace_back(key); });
  return keys;
}

std::string nameOf(const Job& job) { return job.group + " " + job.test_piece + " (" + job.id.substr(0, 12) + ")"; }

std::string jobId(const Job& job, const std::vector<InputFile>& inputs, const std::string& version) {
  const ordered_json json = {{"version", version},
                             {"command", toString(job.command)},
                             {"component", job.component},
                             {"config", inputs.at(job.config).content.sha256},
                             {"logs", filesJson(job.logs, inputs)},
                             {"hold_out", filesJson(job.hold_out, inputs)},
                             {"specification", job.specification},
                             {"options", optionsJson(job.options)}};
  return io::sha256(json.dump());
}

ordered_json jobJson(const Job& job) {
  ordered_json json;
  forEachMember([&, empty = Job()](const char* key, auto member, bool always) {
    if (always || job.*member != empty.*member) {
      json[key] = job.*member;
    }
  });
  json["command"] = toString(job.command);
  json["options"] = optionsJson(job.options);
  return json;
}

Job jobFromJson(const nlohmann::json& json) {
  Job job;
  forEachMember([&](const char* key, auto member, bool always) {
    if (always || json.contains(key)) {
      json.at(key).get_to(job.*member);
    }
  });
  const auto command = json.at("command").get<std::string>();
  job.command = require(commandFromString(command), command);
  job.options = optionsFromJson(json.at("options"));
  return job;
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
    file.line(jobJson(job).dump());
  }
  file.commit();
}

Manifest readManifest(const std::string& folder) {
  LineReader lines(manifestPath(folder));
  try {
    return readLines(lines);
  } catch (const std::exception& error) {
    lines.refuse(error.what());
  }
}

}  // namespace rubber_suspension::campaign
