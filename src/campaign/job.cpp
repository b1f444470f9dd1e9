// Jobs, their ids, and their lines in a manifest.
#include "campaign/job.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>

#include "element/suggestion.h"
#include "io/sha256.h"

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
  ordered_json result = ordered_json::array();
  for (const std::size_t file : files) {
    result.push_back({inputs.at(file).sha256, std::filesystem::path(inputs.at(file).path).stem().string()});
  }
  return result;
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
    if (std::find(known.begin(), known.end(), entry.key()) == known.end()) {
      throw std::invalid_argument("'" + entry.key() + "' is unknown" + element::didYouMean(entry.key(), known));
    }
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
                             {"config", inputs.at(job.config).sha256},
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

}  // namespace rubber_suspension::campaign
