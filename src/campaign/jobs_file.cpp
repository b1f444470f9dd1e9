// The jobs file: a strict loader that continues after a problem, so that all are told at once; specifications drawn
// within their tolerances.
#include "campaign/jobs_file.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <type_traits>

#include "campaign/make.h"
#include "element/each.h"
#include "element/refuse.h"
#include "element/suggestion.h"
#include "io/effect_names.h"
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

// Keys of every entry of `jobs:` besides the options, which `settings:` gives for all of them.
const Keys kGroupKeys = {"command",  "folders", "config",   "component",       "type",
                         "test_rig", "log",     "hold_out", "one_job_per_log", "monte_carlo"};

// Receives what is wrong, with its line and where it stands.
using Tell = std::function<void(int line, const std::string& path, const std::string& problem)>;

int lineOf(const YAML::Mark& mark) { return std::max(mark.line + 1, 1); }

using element::namesOf;

// A node of the file and where it stands, "jobs.fleet.log". What is wrong with it is told, and what it holds is then
// empty.
class Entry {
 public:
  Entry(const YAML::Node& node, const std::string& parent, std::string name, int line, const Tell& tell)
      : node_(node),
        name_(std::move(name)),
        path_(parent + (parent.empty() ? "" : ".") + log::oneLine(name_)),
        line_(line),
        tell_(&tell) {}

  bool given() const { return node_.IsDefined(); }
  const std::string& name() const { return name_; }
  int line() const { return line_; }

  // Of a map.
  Entry at(const std::string& key) const {
    const YAML::Node node = node_[key];
    return {node, path_, key, node.IsDefined() ? lineOf(node.Mark()) : line_, *tell_};
  }

  void refuse(const std::string& problem) const { (*tell_)(line_, path_, problem); }

  // The value given, and the values accepted.
  void refuseContent(const std::string& accepted) const {
    std::string content = "missing";
    if (given()) {
      content = node_.IsScalar()     ? log::quoted(node_.Scalar())
                : node_.IsMap()      ? "a map"
                : node_.IsSequence() ? "a list"
                                     : "nothing";
    }
    refuse(content + "; accepted: " + accepted);
  }

  bool isFullMap() const { return given() && node_.IsMap() && node_.size() > 0; }

  // True for a map, whatever its keys; those that are unknown are told.
  bool isMapOf(const Keys& keys) const {
    if (!given() || !node_.IsMap()) {
      refuseContent("a map with the keys " + log::join(keys));
      return false;
    }
    for (const Entry& entry : entries()) {
      if (std::find(keys.begin(), keys.end(), entry.name()) == keys.end()) {
        entry.refuse(
            fmt::format("unknown key{}; accepted: {}", element::didYouMean(entry.name(), keys), log::join(keys)));
      }
    }
    return true;
  }

  // Those of a map, each key once, with the line of the key.
  std::vector<Entry> entries() const {
    std::vector<Entry> entries;
    std::set<std::string> seen;
    for (const auto& entry : node_) {
      const int line = lineOf(entry.first.Mark());
      if (!entry.first.IsScalar()) {
        (*tell_)(line, path_, "a key that is no name; accepted: a name");
        continue;
      }
      const std::string name = entry.first.Scalar();
      entries.push_back({entry.second, path_, name, line, *tell_});
      if (!seen.insert(name).second) {
        entries.back().refuse("stands twice; accepted: once");
        entries.pop_back();
      }
    }
    return entries;
  }

  std::string text() const {
    if (given() && node_.IsScalar() && !node_.Scalar().empty()) {
      return node_.Scalar();
    }
    refuseContent("text");
    return "";
  }

  // A list, or a single text.
  Keys texts() const {
    Keys texts;
    if (given() && node_.IsSequence() && node_.size() > 0) {
      for (const YAML::Node& node : node_) {
        texts.push_back(Entry(node, "", path_, lineOf(node.Mark()), *tell_).text());
      }
    } else {
      texts.push_back(text());
    }
    texts.erase(std::remove(texts.begin(), texts.end(), ""), texts.end());
    return texts;
  }

  std::optional<double> number(double lower, double upper, bool whole) const {
    const auto result = given() && node_.IsScalar() ? log::parseNumber(node_.Scalar()) : std::nullopt;
    if (!result || !(*result >= lower && *result <= upper) || (whole && std::floor(*result) != *result)) {
      refuseContent(fmt::format("a {}number from {:.17g} to {:.17g}", whole ? "whole " : "", lower, upper));
      return std::nullopt;
    }
    return result;
  }

  // One of the words that `of` knows.
  template <class Value>
  std::optional<Value> choice(std::optional<Value> (*of)(const std::string&), const char* accepted) const {
    const std::string word = text();
    const std::optional<Value> value = of(word);
    if (!value && !word.empty()) {
      refuseContent(accepted);
    }
    return value;
  }

 private:
  YAML::Node node_;
  std::string name_;
  std::string path_;
  int line_;
  const Tell* tell_;
};

std::optional<bool> flagFromString(const std::string& word) {
  bool flag = false;
  return YAML::convert<bool>::decode(YAML::Node(word), flag) ? std::make_optional(flag) : std::nullopt;
}

std::optional<bool> leavesOut(const std::string& word) {
  return word == "leave_out" || word == "refuse" ? std::make_optional(word == "leave_out") : std::nullopt;
}

void read(const Entry& entry, std::string& value) { value = entry.text(); }

void read(const Entry& entry, std::vector<std::string>& values) { values = entry.texts(); }

void read(const Entry& entry, bool& flag) { flag = entry.choice(flagFromString, "true, false").value_or(flag); }

void read(const Entry& entry, int& starts) { starts = static_cast<int>(entry.number(1, 1000, true).value_or(starts)); }

// The rate [Hz] ends where a stamp, a whole number of nanoseconds, does; a gap that is bridged [s] is no hour.
void read(const Entry& entry, double& value, bool is_rate) {
  value = (is_rate ? entry.number(1e-9, 1e9, false) : entry.number(0.0, 3600.0, false)).value_or(value);
}

// Tolerances of a rig.
void read(const Entry& entry, std::map<std::string, std::string>& rig) {
  const Keys known = namesOf(io::rigToleranceTable());
  if (!entry.isMapOf(known)) {
    return;
  }
  for (const std::string& key : known) {
    const Entry tolerance = entry.at(key);
    try {
      if (tolerance.given()) {
        io::parseRigTolerance(key, rig[key] = tolerance.text());
      }
    } catch (const std::invalid_argument& error) {
      tolerance.refuse(error.what());
    }
  }
}

template <class Value>
void readIfGiven(const Entry& entry, Value& value) {
  if (entry.given()) {
    read(entry, value);
  }
}

void readOptions(const Entry& entry, JobOptions& options) {
  if (const Entry reports = entry.at("reports"); reports.given()) {
    options.reports = reports.choice(reportsFromString, "none, data, full").value_or(options.reports);
  }
  forEachOption([&](const std::string& key, auto option) {
    if constexpr (std::is_same_v<decltype(option), double JobOptions::*>) {
      if (entry.at(key).given()) {
        read(entry.at(key), options.*option, key == "sampling_rate");
      }
    } else {
      readIfGiven(entry.at(key), options.*option);
    }
  });
  if (options.evidence && options.reports == Reports::none) {
    entry.refuse("evidence: true leaves a file, and reports: none leaves none; accepted: reports: data, full");
  }
  for (const std::string& effect : options.exclude) {
    const Keys& names = io::effectNames();
    if (std::find(names.begin(), names.end(), effect) == names.end()) {
      entry.at("exclude").refuse(fmt::format("{} is no effect{}; accepted: {}", log::quoted(effect),
                                             element::didYouMean(effect, names), log::join(names)));
    }
  }
  try {
    logFormat(options);
  } catch (const std::invalid_argument& error) {
    entry.refuse(error.what());
  }
}

std::optional<Tolerance> readTolerance(const Entry& entry, const element::ParameterInfo& row) {
  if (!entry.isMapOf({"uniform", "normal"})) {
    return std::nullopt;
  }
  const bool is_normal = entry.at("normal").given();
  if (is_normal == entry.at("uniform").given()) {
    entry.refuse("accepted: one of uniform and normal, as a share such as 5 %, or in " + row.unit);
    return std::nullopt;
  }
  const std::string text = log::trimmed(entry.at(is_normal ? "normal" : "uniform").text());
  const bool is_share = log::endsWith(text, "%");
  try {
    const double width = log::parseQuantity(text, is_share ? "1" : row.unit);
    if (std::isfinite(width) && width > 0.0 && !(is_share && width >= 1.0)) {
      return Tolerance{is_normal ? Tolerance::Shape::normal : Tolerance::Shape::uniform, width, is_share};
    }
    entry.refuse(log::quoted(text) + "; accepted: greater than 0, as a share below 100 %");
  } catch (const std::invalid_argument& error) {
    entry.refuse(
        fmt::format("{}: {}; accepted: a share such as 5 %, or in {}", log::quoted(text), error.what(), row.unit));
  }
  return std::nullopt;
}

MonteCarlo readMonteCarlo(const Entry& entry) {
  constexpr double kLargestSeed = 9007199254740992.0;  // 2^53: whole numbers up to it are exact
  MonteCarlo result;
  if (!entry.isMapOf({"runs", "seed", "tolerances", "unsolvable"})) {
    return result;
  }
  result.runs = static_cast<std::size_t>(entry.at("runs").number(1.0, kMaximumJobs, true).value_or(0.0));
  result.seed = static_cast<std::uint64_t>(entry.at("seed").number(0.0, kLargestSeed, true).value_or(0.0));
  if (entry.at("unsolvable").given()) {
    result.leave_out_unsolvable = entry.at("unsolvable").choice(leavesOut, "refuse, leave_out").value_or(false);
  }
  const Entry tolerances = entry.at("tolerances");
  const std::vector<element::ParameterInfo>& table = estimation::specificationParameters();
  if (!tolerances.isFullMap()) {
    tolerances.refuse("missing or empty; accepted: a map such as static_stiffness: {uniform: 15 %}");
  } else if (tolerances.isMapOf(namesOf(table))) {
    for (const element::ParameterInfo& row : table) {
      const Entry one = tolerances.at(row.name);
      if (const auto tolerance = one.given() ? readTolerance(one, row) : std::nullopt) {
        result.tolerances[row.name] = *tolerance;
      }
    }
  }
  return result;
}

// No key is without effect.
void checkUse(const Entry& entry, Command command) {
  static const std::vector<std::pair<std::string, Command>> only = {
      {"rig", Command::diagnose},     {"evidence", Command::diagnose}, {"test_rig", Command::diagnose},
      {"exclude", Command::diagnose}, {"hold_out", Command::diagnose}, {"hold", Command::estimate},
      {"starts", Command::estimate}};
  for (const auto& [key, needed] : only) {
    if (entry.at(key).given() && command != needed) {
      entry.at(key).refuse(fmt::format("has no effect on {}; accepted: with {}", toString(command), toString(needed)));
    }
  }
  if (entry.at("accept_units").given() && command == Command::replay) {
    entry.at("accept_units").refuse("has no effect on replay; accepted: with diagnose or estimate");
  }
}

JobGroup readGroup(const Entry& entry, const JobOptions& settings) {
  JobGroup group;
  group.name = entry.name();
  group.line = entry.line();
  group.options = settings;
  Keys keys = kGroupKeys;
  const Keys options = optionKeys();
  keys.insert(keys.end(), options.begin(), options.end());
  if (group.name.empty() || group.name != log::oneLine(group.name)) {
    entry.refuse("no name; accepted: text on one line");
  }
  if (!entry.isMapOf(keys)) {
    return group;
  }
  group.command = entry.at("command").choice(commandFromString, "diagnose, estimate, replay").value_or(group.command);
  readIfGiven(entry.at("folders"), group.folders);
  group.config = entry.at("config").text();
  readIfGiven(entry.at("type"), group.type);
  readIfGiven(entry.at("test_rig"), group.test_rig);
  readIfGiven(entry.at("component"), group.components);
  group.logs = entry.at("log").texts();
  readIfGiven(entry.at("hold_out"), group.hold_out);
  readIfGiven(entry.at("one_job_per_log"), group.one_job_per_log);
  readOptions(entry, group.options);
  if (entry.at("monte_carlo").given()) {
    group.monte_carlo = readMonteCarlo(entry.at("monte_carlo"));
  }
  checkUse(entry, group.command);
  return group;
}

std::optional<YAML::Node> parse(const std::string& text, const Tell& tell) {
  try {
    if (const auto problem = io::beyondYamlBounds(text)) {
      tell(problem->line, "", problem->text);
    } else {
      return YAML::Load(text);
    }
  } catch (const YAML::Exception& error) {
    tell(lineOf(error.mark), "", fmt::format("not YAML: {}; accepted: a jobs file", error.msg));
  }
  return std::nullopt;
}

std::vector<JobGroup> readGroups(const Entry& root) {
  if (!root.isMapOf({"settings", "jobs"})) {
    return {};
  }
  JobOptions settings;
  const Entry given = root.at("settings");
  if (given.given() && given.isMapOf(optionKeys())) {
    readOptions(given, settings);
  }
  const Entry jobs = root.at("jobs");
  if (!jobs.isFullMap()) {
    jobs.refuse("missing or empty; accepted: a map of entries by name");
    return {};
  }
  return element::each(jobs.entries(), [&](const Entry& entry) { return readGroup(entry, settings); });
}

// In (0, 1), never its ends: a normal number would be infinite there.
double uniform(std::mt19937_64& generator) {
  constexpr int kBits = 53;  // of a double's significand
  return std::ldexp(static_cast<double>(generator() >> (64 - kBits)) + 0.5, -kBits);
}

double draw(double nominal, const Tolerance& tolerance, std::mt19937_64& generator) {
  const double width = tolerance.is_share ? tolerance.width * std::abs(nominal) : tolerance.width;
  const double place = 2.0 * uniform(generator) - 1.0;
  return nominal +
         width * (tolerance.shape == Tolerance::Shape::uniform ? place : std::sqrt(2.0) * boost::math::erf_inv(place));
}

void checkNames(const estimation::Specification& nominal, const MonteCarlo& study) {
  const auto names = element::joined(nominal.values(), ", ", [](const auto& one) { return one.first; });
  for (const auto& [name, tolerance] : study.tolerances) {
    element::refuseIf(!nominal.has(name), "monte_carlo.tolerances.{}: the component does not specify it; accepted: {}",
                      name, names.empty() ? "a component with a specification" : names);
  }
}

}  // namespace

JobsFile parseJobsFile(const std::string& text, const std::string& path, std::vector<std::string>& problems) {
  const Tell tell = [&](int line, const std::string& key, const std::string& problem) {
    problems.push_back(fmt::format("{}:{}: {}{}{}", path, line, key, key.empty() ? "" : ": ", problem));
  };
  const std::optional<YAML::Node> root = parse(text, tell);
  return {path, root ? readGroups(Entry(*root, "", "", 1, tell)) : std::vector<JobGroup>()};
}

JobsFile readJobsFile(const std::string& path, std::vector<std::string>& problems) {
  try {
    return parseJobsFile(log::readInput(path, kMaximumSize, "; accepted: a jobs file"), path, problems);
  } catch (const std::runtime_error& error) {
    problems.emplace_back(error.what());
    return {path, {}};
  }
}

std::vector<std::map<std::string, double>> drawSpecifications(const estimation::Specification& nominal,
                                                              const MonteCarlo& study) {
  checkNames(nominal, study);
  std::mt19937_64 generator(study.seed);
  std::vector<std::map<std::string, double>> draws(study.runs);
  for (auto& numbers : draws) {
    for (const auto& [name, tolerance] : study.tolerances) {
      numbers[name] = draw(nominal.at(name), tolerance, generator);
    }
  }
  return draws;
}

}  // namespace rubber_suspension::campaign
