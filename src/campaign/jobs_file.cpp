// The jobs file: a strict loader that continues after a problem, so that all are told at once.
#include "campaign/jobs_file.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "campaign/make.h"
#include "element/suggestion.h"
#include "io/yaml_bounds.h"
#include "log/text.h"
#include "rubber_suspension/estimation/specification.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::campaign {
namespace {

constexpr std::size_t kMaximumSize = 1024 * 1024;  // bytes; a jobs file is some screens

using Keys = std::vector<std::string>;

// What every entry of `jobs:` may say besides the options, which `settings:` says for all of them.
const Keys kGroupKeys = {"command",  "folders", "config",   "component",       "type",
                         "test_rig", "log",     "hold_out", "one_job_per_log", "monte_carlo"};

class Reader {
 public:
  Reader(std::string path, std::vector<std::string>& problems) : path_(std::move(path)), problems_(problems) {}

  std::vector<JobGroup> read(const std::string& text) {
    const std::optional<YAML::Node> root = parse(text);
    std::vector<JobGroup> groups;
    if (!root || !checkMap(*root, "", {"settings", "jobs"})) {
      return groups;
    }
    JobOptions settings;
    if ((*root)["settings"] && checkMap((*root)["settings"], "settings", optionKeys())) {
      readOptions((*root)["settings"], "settings", settings);
    }
    const YAML::Node jobs = (*root)["jobs"];
    if (!jobs || !jobs.IsMap() || jobs.size() == 0) {
      report(jobs ? jobs : *root, "jobs", "missing or empty; accepted: a map of entries by name");
      return groups;
    }
    checkUnique(jobs, "jobs");
    for (const auto& entry : jobs) {
      groups.push_back(readGroup(entry.first, entry.second, settings));
    }
    return groups;
  }

 private:
  void report(int line, const std::string& key, const std::string& problem) {
    problems_.push_back(fmt::format("{}:{}: {}{}{}", path_, line, key, key.empty() ? "" : ": ", problem));
  }

  void report(const YAML::Node& node, const std::string& key, const std::string& problem) {
    report(std::max(node.Mark().line + 1, 1), key, problem);
  }

  std::optional<YAML::Node> parse(const std::string& text) {
    if (const auto line = io::lineNestedTooDeep(text)) {
      report(*line, "", io::acceptedNesting());
      return std::nullopt;
    }
    try {
      if (const auto line = io::lineExpandedTooFar(text)) {
        report(*line, "", io::acceptedExpansion());
        return std::nullopt;
      }
      return YAML::Load(text);
    } catch (const YAML::Exception& error) {
      report(std::max(error.mark.line + 1, 1), "", fmt::format("not YAML: {}; accepted: a jobs file", error.msg));
      return std::nullopt;
    }
  }

  void checkUnique(const YAML::Node& map, const std::string& path) {
    std::set<std::string> seen;
    for (const auto& entry : map) {
      if (!entry.first.IsScalar()) {
        report(entry.first, path, "a key that is no name; accepted: a name");
      } else if (!seen.insert(entry.first.Scalar()).second) {
        report(entry.first, child(path, entry.first.Scalar()), "stands twice; accepted: once");
      }
    }
  }

  // True for a map, whatever its keys; those that are unknown are told.
  bool checkMap(const YAML::Node& node, const std::string& path, const Keys& keys) {
    if (!node.IsMap()) {
      report(node, path, fmt::format("{}; accepted: a map with the keys {}", describe(node), log::join(keys)));
      return false;
    }
    checkUnique(node, path);
    for (const auto& entry : node) {
      if (entry.first.IsScalar() && std::find(keys.begin(), keys.end(), entry.first.Scalar()) == keys.end()) {
        report(entry.first, child(path, log::oneLine(entry.first.Scalar())),
               fmt::format("unknown key{}; accepted: {}", element::didYouMean(entry.first.Scalar(), keys),
                           log::join(keys)));
      }
    }
    return true;
  }

  static std::string child(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
  }

  static std::string describe(const YAML::Node& node) {
    if (node.IsScalar()) {
      return log::quoted(node.Scalar());
    }
    return node.IsMap() ? "a map" : (node.IsSequence() ? "a list" : "nothing");
  }

  JobGroup readGroup(const YAML::Node& key, const YAML::Node& node, const JobOptions& settings) {
    JobGroup group;
    group.name = key.IsScalar() ? key.Scalar() : "";
    group.line = key.Mark().line + 1;
    group.options = settings;
    const std::string path = "jobs." + log::oneLine(group.name);
    Keys keys = kGroupKeys;
    const Keys options = optionKeys();
    keys.insert(keys.end(), options.begin(), options.end());
    if (group.name.empty() || group.name != log::oneLine(group.name)) {
      report(key, path, "no name; accepted: text on one line");
    }
    if (!checkMap(node, path, keys)) {
      return group;
    }
    readCommand(node, path, group);
    group.folders = text(node, path, "folders", false);
    group.config = text(node, path, "config", true);
    group.type = text(node, path, "type", false);
    group.test_rig = text(node, path, "test_rig", false);
    group.components = texts(node, path, "component", false);
    group.logs = texts(node, path, "log", true);
    group.hold_out = texts(node, path, "hold_out", false);
    readFlag(node, path, "one_job_per_log", group.one_job_per_log);
    readOptions(node, path, group.options);
    if (node["monte_carlo"]) {
      group.monte_carlo = readMonteCarlo(node["monte_carlo"], path + ".monte_carlo");
    }
    checkUse(node, path, group);
    return group;
  }

  void readCommand(const YAML::Node& node, const std::string& path, JobGroup& group) {
    const std::string name = text(node, path, "command", true);
    const auto command = commandFromString(name);
    if (command) {
      group.command = *command;
    } else if (!name.empty()) {
      report(node["command"], path + ".command",
             fmt::format("{}; accepted: diagnose, estimate, replay", log::quoted(name)));
    }
  }

  // No key is without effect.
  void checkUse(const YAML::Node& node, const std::string& path, const JobGroup& group) {
    const auto refuse = [&](const char* key, Command needed) {
      if (node[key] && group.command != needed) {
        report(node[key], child(path, key),
               fmt::format("has no effect on {}; accepted: with {}", toString(group.command), toString(needed)));
      }
    };
    refuse("rig", Command::diagnose);
    refuse("evidence", Command::diagnose);
    refuse("test_rig", Command::diagnose);
    refuse("hold_out", Command::diagnose);
    refuse("hold", Command::estimate);
    refuse("starts", Command::estimate);
    if (node["accept_units"] && group.command == Command::replay) {
      report(node["accept_units"], child(path, "accept_units"),
             "has no effect on replay; accepted: with diagnose or estimate");
    }
  }

  std::string text(const YAML::Node& node, const std::string& path, const char* key, bool required) {
    const YAML::Node value = node[key];
    if (!value && !required) {
      return "";
    }
    if (!value || !value.IsScalar() || value.Scalar().empty()) {
      report(value ? value : node, child(path, key),
             fmt::format("{}; accepted: text", value ? describe(value) : "missing"));
      return "";
    }
    return value.Scalar();
  }

  std::vector<std::string> texts(const YAML::Node& node, const std::string& path, const char* key, bool required) {
    const YAML::Node value = node[key];
    std::vector<std::string> result;
    if (value && value.IsSequence() && value.size() > 0) {
      for (const YAML::Node& entry : value) {
        if (entry.IsScalar() && !entry.Scalar().empty()) {
          result.push_back(entry.Scalar());
        } else {
          report(entry, child(path, key), fmt::format("{}; accepted: text", describe(entry)));
        }
      }
      return result;
    }
    const std::string only = text(node, path, key, required);
    return only.empty() ? result : std::vector<std::string>{only};
  }

  void readFlag(const YAML::Node& node, const std::string& path, const char* key, bool& flag) {
    const YAML::Node value = node[key];
    if (value && !YAML::convert<bool>::decode(value, flag)) {
      report(value, child(path, key), fmt::format("{}; accepted: true, false", describe(value)));
    }
  }

  // A number of [lower, upper], or nothing and a problem.
  std::optional<double> number(const YAML::Node& value, const std::string& path, double lower, double upper,
                               bool whole) {
    const auto result = value.IsScalar() ? log::parseNumber(value.Scalar()) : std::nullopt;
    if (!result || !(*result >= lower && *result <= upper) || (whole && std::floor(*result) != *result)) {
      report(value, path,
             fmt::format("{}; accepted: a {}number from {:.17g} to {:.17g}", describe(value), whole ? "whole " : "",
                         lower, upper));
      return std::nullopt;
    }
    return result;
  }

  void readOptions(const YAML::Node& node, const std::string& path, JobOptions& options) {
    if (node["reports"]) {
      const std::string name = text(node, path, "reports", true);
      const auto reports = reportsFromString(name);
      if (reports) {
        options.reports = *reports;
      } else if (!name.empty()) {
        report(node["reports"], child(path, "reports"),
               fmt::format("{}; accepted: none, data, full", log::quoted(name)));
      }
    }
    readFlag(node, path, "evidence", options.evidence);
    if (options.evidence && options.reports == Reports::none) {
      report(node, path, "evidence: true leaves a file, and reports: none leaves none; accepted: reports: data, full");
    }
    if (node["sampling_rate"]) {
      constexpr double kFastest = 1e9;  // [Hz]: a stamp is a whole number of nanoseconds
      options.sampling_rate =
          number(node["sampling_rate"], child(path, "sampling_rate"), 1e-9, kFastest, false).value_or(0.0);
    }
    if (node["starts"]) {
      if (const auto starts = number(node["starts"], child(path, "starts"), 1, 1000, true)) {
        options.starts = static_cast<int>(*starts);
      }
    }
    for (const auto& [key, option] : {std::pair("columns", &options.columns), std::pair("hold", &options.hold)}) {
      if (node[key]) {
        *option = texts(node, path, key, true);
      }
    }
    for (const auto& [key, option] : {std::pair("unit", &options.unit), std::pair("decimal", &options.decimal),
                                      std::pair("segment", &options.segment)}) {
      if (node[key]) {
        *option = text(node, path, key, true);
      }
    }
    if (node["bridge"]) {
      constexpr double kLongest = 3600.0;  // [s]
      options.bridge = number(node["bridge"], child(path, "bridge"), 0.0, kLongest, false).value_or(-1.0);
    }
    readFlag(node, path, "accept_units", options.accept_units);
    checkFormat(node, path, options);
    readRig(node["rig"], child(path, "rig"), options);
  }

  void checkFormat(const YAML::Node& node, const std::string& path, const JobOptions& options) {
    try {
      logFormat(options);
    } catch (const std::invalid_argument& error) {
      report(node, path, error.what());
    }
  }

  void readRig(const YAML::Node& node, const std::string& path, JobOptions& options) {
    if (!node) {
      return;
    }
    Keys keys;
    for (const io::RigToleranceInfo& row : io::rigToleranceTable()) {
      keys.push_back(row.name);
    }
    if (!checkMap(node, path, keys)) {
      return;
    }
    for (const auto& entry : node) {
      const std::string key = entry.first.Scalar();
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
        continue;  // told already
      }
      try {
        io::parseRigTolerance(key, entry.second.IsScalar() ? entry.second.Scalar() : "");
        options.rig[key] = entry.second.Scalar();
      } catch (const std::invalid_argument& error) {
        report(entry.second, child(path, key), error.what());
      }
    }
  }

  MonteCarlo readMonteCarlo(const YAML::Node& node, const std::string& path) {
    MonteCarlo result;
    if (!checkMap(node, path, {"runs", "seed", "tolerances", "unsolvable"})) {
      return result;
    }
    const auto whole = [&](const char* key, double lower, double upper) {
      if (!node[key]) {
        report(node, child(path, key), fmt::format("missing; accepted: a whole number from {:.17g}", lower));
        return 0.0;
      }
      return number(node[key], child(path, key), lower, upper, true).value_or(0.0);
    };
    constexpr double kLargestSeed = 9007199254740992.0;  // 2^53: whole numbers up to it are exact
    result.runs = static_cast<std::size_t>(whole("runs", 1.0, static_cast<double>(kMaximumJobs)));
    result.seed = static_cast<std::uint64_t>(whole("seed", 0.0, kLargestSeed));
    if (node["unsolvable"]) {
      const std::string choice = text(node, path, "unsolvable", true);
      result.leave_out_unsolvable = choice == "leave_out";
      if (choice != "leave_out" && choice != "refuse") {
        report(node["unsolvable"], child(path, "unsolvable"),
               fmt::format("{}; accepted: refuse, leave_out", log::quoted(choice)));
      }
    }
    readTolerances(node["tolerances"] ? node["tolerances"] : YAML::Node(), node, child(path, "tolerances"), result);
    return result;
  }

  void readTolerances(const YAML::Node& node, const YAML::Node& parent, const std::string& path, MonteCarlo& result) {
    if (!node.IsMap() || node.size() == 0) {
      report(node.IsDefined() && !node.IsNull() ? node : parent, path,
             "missing or empty; accepted: a map such as static_stiffness: {uniform: 15 %}");
      return;
    }
    Keys names;
    for (const element::ParameterInfo& row : estimation::specificationParameters()) {
      names.push_back(row.name);
    }
    checkMap(node, path, names);
    for (const auto& entry : node) {
      const auto* row = entry.first.IsScalar()
                            ? element::findParameter(estimation::specificationParameters(), entry.first.Scalar())
                            : nullptr;
      if (row != nullptr) {
        readTolerance(entry.second, child(path, row->name), *row, result);
      }
    }
  }

  void readTolerance(const YAML::Node& node, const std::string& path, const element::ParameterInfo& row,
                     MonteCarlo& result) {
    if (!checkMap(node, path, {"uniform", "normal"})) {
      return;
    }
    if (node.size() != 1 || !node.begin()->second.IsScalar()) {
      report(node, path,
             fmt::format("accepted: one of uniform and normal, as a share such as 5 %, or in {}", row.unit));
      return;
    }
    Tolerance tolerance;
    tolerance.shape = node["normal"] ? Tolerance::Shape::normal : Tolerance::Shape::uniform;
    const std::string value = log::trimmed(node.begin()->second.Scalar());
    tolerance.is_share = !value.empty() && value.back() == '%';
    try {
      tolerance.width = log::parseQuantity(value, tolerance.is_share ? "1" : row.unit);
    } catch (const std::invalid_argument& error) {
      report(
          node, path,
          fmt::format("{}: {}; accepted: a share such as 5 %, or in {}", log::quoted(value), error.what(), row.unit));
      return;
    }
    if (!(std::isfinite(tolerance.width) && tolerance.width > 0.0 && !(tolerance.is_share && tolerance.width >= 1.0))) {
      report(node, path, fmt::format("{}; accepted: greater than 0, as a share below 100 %", log::quoted(value)));
      return;
    }
    result.tolerances[row.name] = tolerance;
  }

  std::string path_;
  std::vector<std::string>& problems_;
};

}  // namespace

JobsFile parseJobsFile(const std::string& text, const std::string& path, std::vector<std::string>& problems) {
  return {path, Reader(path, problems).read(text)};
}

JobsFile readJobsFile(const std::string& path, std::vector<std::string>& problems) {
  std::string text;
  try {
    text = log::readFile(path, kMaximumSize);
  } catch (const std::exception& error) {
    problems.push_back(fmt::format("{}: {}; accepted: a jobs file", path, error.what()));
    return {path, {}};
  }
  return parseJobsFile(text, path, problems);
}

}  // namespace rubber_suspension::campaign
