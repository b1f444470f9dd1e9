// Reads the jobs file into a list of entries with their options, and draws specifications within their tolerances.
#include "campaign/jobs_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <random>

#include "campaign/make.h"
#include "element/each.h"
#include "element/refuse.h"
#include "element/suggestion.h"
#include "io/effect_names.h"
#include "io/yaml_reader.h"
#include "log/text.h"
#include "rubber_suspension/estimation/specification.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::campaign {
namespace {

constexpr double kLargestSeed = 9007199254740992.0;  // 2^53; smaller whole numbers are exact in a double

using io::Entry;
using io::Key;

// Continues after a problem, so that the user sees all problems at once.
class JobsReader : public io::YamlReader {
 public:
  JobsReader(const std::string& source, std::vector<std::string>& problems)
      : YamlReader(source, "a jobs file", "jobs") {
    problems_ = &problems;
  }

  std::vector<JobGroup> load(const std::string& text) {
    std::vector<JobGroup> groups;
    attempt([&] {
      const Entry root{parse(text), ""};
      JobOptions settings;
      const std::vector<Key<JobOptions>> keys = optionKeys<JobOptions>([](auto& options) -> auto& { return options; });
      checkMap(root, {"settings", "jobs"}, "a map with the keys settings, jobs");
      if (const Entry given = root["settings"]) {
        read(given, keys, settings);
        attempt([&] { checkOptions(given, settings); });
      }
      const Entry jobs = loadFullMap(root, "jobs", "a map of entries by name");
      checkUnique(jobs);
      for (const auto& job : jobs.node) {
        attempt([&] { groups.push_back(loadGroup(keyOf(jobs, job.first), jobs[job.first.Scalar()], settings)); });
      }
    });
    return groups;
  }

 private:
  // Returns a function that loads the value of a key into this member of a target.
  template <class Member>
  auto to(Member member) {
    return [this, member](const Entry& entry, auto& target) { this->load(entry, target.*member); };
  }

  // Returns the keys of all options. `of` returns the options of a target.
  template <class Target, class Of>
  std::vector<Key<Target>> optionKeys(Of of) {
    std::vector<Key<Target>> keys;
    forEachOption([&](const char* key, auto option) {
      keys.push_back({key, [=](const Entry& entry, Target& target) { load(entry, of(target).*option); }});
    });
    return keys;
  }

  void load(const Entry& entry, std::string& value) {
    if (!entry.isText() || entry.text().empty()) {
      refuseContent(entry, "text");
    }
    value = entry.text();
  }

  // Accepts a list or a single text.
  void load(const Entry& entry, std::vector<std::string>& values) {
    const bool is_list = entry.node.IsSequence() && entry.node.size() > 0;
    values.resize(is_list ? entry.node.size() : 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
      load(is_list ? entry[i] : entry, values[i]);
    }
  }

  void load(const Entry& entry, bool& flag) {
    if (!YAML::convert<bool>::decode(entry.node, flag)) {
      refuseContent(entry, "true, false");
    }
  }

  void load(const Entry& entry, int& starts) { starts = static_cast<int>(loadWhole(entry, 1.0, 1000.0)); }

  // A sampling rate is at most 1e9 Hz because stamps are whole nanoseconds. A bridged time gap lasts at most an hour.
  void load(const Entry& entry, double& value) {
    const bool is_rate = log::endsWith(entry.path, "sampling_rate");
    value = is_rate ? loadWithin(entry, 1e-9, 1e9, "a number from 1e-9 to 1e9")
                    : loadWithin(entry, 0.0, 3600.0, "a number from 0 to 3600");
  }

  void load(const Entry& entry, Command& command) {
    command = static_cast<Command>(loadWord(entry, kCommands, "a command"));
  }

  void load(const Entry& entry, Reports& reports) {
    reports = static_cast<Reports>(loadWord(entry, kReports, "a value of this key"));
  }

  void load(const Entry& entry, std::map<std::string, std::string>& rig) {
    loadRig(entry);  // refuses wrong tolerances; the manifest contains their text
    for (const auto& tolerance : entry.node) {
      rig[tolerance.first.Scalar()] = tolerance.second.Scalar();
    }
  }

  void load(const Entry& entry, std::optional<MonteCarlo>& study) {
    const std::vector<Key<MonteCarlo>> keys = {
        {"runs",
         [this](const Entry& runs, MonteCarlo& target) {
           target.runs = static_cast<std::size_t>(loadWhole(runs, 1.0, kMaximumJobs));
         },
         wholeFrom(1.0, kMaximumJobs)},
        {"seed",
         [this](const Entry& seed, MonteCarlo& target) {
           target.seed = static_cast<std::uint64_t>(loadWhole(seed, 0.0, kLargestSeed));
         },
         wholeFrom(0.0, kLargestSeed)},
        {"tolerances"},
        {"unsolvable", [this](const Entry& word, MonteCarlo& target) {
           target.leave_out_unsolvable = loadWord(word, {"refuse", "leave_out"}) == 1;
         }}};
    study.emplace();
    read(entry, keys, *study);
    std::vector<Key<MonteCarlo>> rows;
    for (const element::ParameterInfo& row : estimation::specificationParameters()) {
      rows.push_back({row.name, [this, &row](const Entry& tolerance, MonteCarlo& target) {
                        target.tolerances[row.name] = loadTolerance(tolerance, row);
                      }});
    }
    read(loadFullMap(entry, "tolerances", "a map such as static_stiffness: {uniform: 15 %}"), rows, *study);
  }

  Tolerance loadTolerance(const Entry& entry, const element::ParameterInfo& row) {
    checkMap(entry, {"uniform", "normal"});
    const bool is_normal = bool(entry["normal"]);
    if (is_normal == bool(entry["uniform"])) {
      refuse(entry, "accepted: either uniform or normal, with a share such as 5 %, or a value in " + row.unit);
    }
    std::string text;
    load(entry[is_normal ? "normal" : "uniform"], text);
    const bool is_share = log::endsWith(log::trimmed(text), "%");
    double width = 0.0;
    try {
      width = log::parseQuantity(text, is_share ? "1" : row.unit);
    } catch (const std::invalid_argument& error) {
      refuse(entry, fmt::format("{}: {}; accepted: a share such as 5 %, or a value in {}", log::quoted(text),
                                error.what(), row.unit));
    }
    if (!std::isfinite(width) || width <= 0.0 || (is_share && width >= 1.0)) {
      refuse(entry, log::quoted(text) + " is out of range; accepted: greater than 0 and, for a share, below 100 %");
    }
    return {is_normal ? Tolerance::Shape::normal : Tolerance::Shape::uniform, width, is_share};
  }

  static std::string wholeFrom(double lower, double upper) {
    return fmt::format("a whole number from {:.17g} to {:.17g}", lower, upper);
  }

  double loadWhole(const Entry& entry, double lower, double upper) const {
    const double number = loadWithin(entry, lower, upper, wholeFrom(lower, upper));
    if (std::floor(number) != number) {
      refuseContent(entry, wholeFrom(lower, upper));
    }
    return number;
  }

  double loadWithin(const Entry& entry, double lower, double upper, const std::string& accepted) const {
    const auto number = entry.isText() ? log::parseNumber(entry.text()) : std::nullopt;
    if (!number || !(*number >= lower && *number <= upper)) {
      refuseContent(entry, accepted);
    }
    return *number;
  }

  Entry loadFullMap(const Entry& parent, const std::string& key, const std::string& accepted) const {
    Entry map = parent[key];
    if (!map || !map.node.IsMap() || map.node.size() == 0) {
      refuse({map ? map.node : parent.node, map.path}, "missing or empty; accepted: " + accepted);
    }
    return map;
  }

  JobGroup loadGroup(const Entry& key, const Entry& entry, const JobOptions& settings) {
    using Group = JobGroup;
    Group group;
    group.name = key.text();
    group.line = key.node.Mark().line + 1;
    group.options = settings;
    if (group.name.empty() || group.name != log::oneLine(group.name)) {
      refuse(key, "the name is empty or has several lines; accepted: text on one line");
    }
    std::vector<Key<Group>> keys = {{"command", to(&Group::command), log::join(kCommands)},
                                    {"folders", to(&Group::folders)},
                                    {"config", to(&Group::config), "text"},
                                    {"component", to(&Group::components)},
                                    {"type", to(&Group::type)},
                                    {"test_rig", to(&Group::test_rig)},
                                    {"log", to(&Group::logs), "text"},
                                    {"hold_out", to(&Group::hold_out)},
                                    {"one_job_per_log", to(&Group::one_job_per_log)},
                                    {"monte_carlo", to(&Group::monte_carlo)}};
    const std::vector<Key<Group>> options = optionKeys<Group>([](auto& target) -> auto& { return target.options; });
    keys.insert(keys.end(), options.begin(), options.end());
    read(entry, keys, group, "a map with the keys command, config, log");
    attempt([&] { checkOptions(entry, group.options); });
    checkUse(entry, group.command);
    return group;
  }

  void checkOptions(const Entry& entry, const JobOptions& options) const {
    const std::vector<std::string>& names = io::effectNames();
    for (const std::string& effect : options.exclude) {
      if (std::find(names.begin(), names.end(), effect) == names.end()) {
        refuse(entry["exclude"], fmt::format("{} is not an effect{}; accepted: {}", log::quoted(effect),
                                             element::didYouMean(effect, names), log::join(names)));
      }
    }
    if (options.evidence && options.reports == Reports::none) {
      refuse(entry,
             "evidence: true needs the folder of a report, but reports: none writes no folder; accepted: reports: "
             "data, full");
    }
    try {
      logFormat(options);
    } catch (const std::invalid_argument& error) {
      refuse(entry, error.what());
    }
  }

  // Refuses keys that have no effect on the command.
  void checkUse(const Entry& entry, Command command) {
    using Commands = std::vector<std::string>;
    static const std::vector<std::pair<std::string, Commands>> uses = {
        {"rig", {"diagnose"}},      {"evidence", {"diagnose"}},
        {"test_rig", {"diagnose"}}, {"exclude", {"diagnose"}},
        {"hold_out", {"diagnose"}}, {"hold", {"estimate"}},
        {"starts", {"estimate"}},   {"accept_units", {"diagnose", "estimate"}}};
    for (const auto& [key, commands] : uses) {
      const bool used = std::find(commands.begin(), commands.end(), toString(command)) != commands.end();
      if (const Entry given = entry[key]; given && !used) {
        const std::string problem = fmt::format("has no effect on the command {}; accepted: the command {}",
                                                toString(command), fmt::join(commands, " or "));
        attempt([&] { refuse(given, problem); });
      }
    }
  }
};

// Returns a number between 0 and 1. Adding 0.5 avoids 0 and 1, for which the normal quantile would be infinite.
double uniform(std::mt19937_64& generator) {
  constexpr int kBits = 52;  // one less than the significand of a double, so that adding 0.5 is exact
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
    element::refuseIf(!nominal.has(name), "monte_carlo.tolerances.{}: is not in the specification; accepted: {}", name,
                      names.empty() ? "a component with a specification" : names);
  }
}

}  // namespace

std::vector<JobGroup> parseJobsFile(const std::string& text, const std::string& path,
                                    std::vector<std::string>& problems) {
  return JobsReader(path, problems).load(text);
}

std::vector<JobGroup> readJobsFile(const std::string& path, std::vector<std::string>& problems) {
  try {
    return parseJobsFile(log::readInput(path, io::kMaximumComponentFileSize, "; accepted: a jobs file"), path,
                         problems);
  } catch (const std::runtime_error& error) {
    problems.emplace_back(error.what());
    return {};
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
