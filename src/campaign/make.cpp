// Makes a manifest from a jobs file.
#include "campaign/make.h"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <unordered_map>
#include <utility>

#include "campaign/jobs_file.h"
#include "element/refuse.h"
#include "element/suggestion.h"
#include "fit/parallel.h"
#include "io/output_files.h"
#include "io/progress.h"
#include "io/sha256.h"
#include "log/text.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::campaign {
namespace {

namespace fs = std::filesystem;

// Escapes the name of a folder, which must not act as a pattern.
std::string escaped(const std::string& text) { return std::regex_replace(text, std::regex(R"([*?[\\])"), R"(\$&)"); }

// Returns the files that match the shell pattern (*, ?, [...]), relative to `folder` unless the pattern begins with a
// slash. The paths are absolute and keep symbolic links. They are sorted by bytes, whatever the locale.
std::vector<std::string> matchPattern(const std::string& folder, const std::string& pattern) {
  const std::string base = fs::absolute(folder.empty() ? "." : folder).lexically_normal().string();
  glob_t matches{};
  const std::unique_ptr<glob_t, void (*)(glob_t*)> freed(&matches, globfree);
  const std::string full = pattern.front() == '/' ? pattern : escaped(base) + "/" + pattern;
  const int status = glob(full.c_str(), GLOB_NOSORT, nullptr, &matches);
  element::refuseIf<std::runtime_error>(status != 0 && status != GLOB_NOMATCH, "{}: a folder cannot be read", full);
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < matches.gl_pathc; ++i) {
    std::string path = fs::path(matches.gl_pathv[i]).lexically_normal().string();
    if (path.size() > 1 && path.back() == '/') {
      path.pop_back();
    }
    paths.push_back(std::move(path));
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

using Components = std::vector<io::ComponentDescription>;

// A log, and a job whose options state how the log is read.
struct Reading {
  std::size_t input;
  Job job;
};

// Contents of one folder of a group.
struct Place {
  std::string name;  // relative to the folder of the jobs file
  std::string config;
  std::vector<io::InputFile> logs;  // including held-out logs
};

constexpr const char* kLog = "log";
constexpr const char* kHoldOut = "hold_out";

std::vector<std::string> componentsOf(const JobGroup& group, const Components& components) {
  if (group.components != std::vector<std::string>{"*"}) {
    return group.components.empty() ? std::vector<std::string>{""} : group.components;
  }
  return element::namesOf(components);
}

void check(const Job& job, const std::string& path, const LogReader& read_log) {
  const log::Log log = read_log(path, job.component, logFormat(job.options));
  element::refuseIf<std::runtime_error>(
      job.command != Command::replay && log.force.empty(),
      "{}: has no measured force; accepted: a log with a column of the measured force", path);
}

// Puts each problem on one line and removes duplicates.
std::vector<std::string> distinctLines(const std::vector<std::string>& problems) {
  std::set<std::string> seen;
  std::vector<std::string> lines;
  for (const std::string& problem : problems) {
    const std::string line = log::oneLine(problem);
    if (seen.insert(line).second) {
      lines.push_back(line);
    }
  }
  return lines;
}

class Maker {
 public:
  Maker(std::string jobs_file, const std::string& output)
      : path_(std::move(jobs_file)),
        base_(fs::absolute(path_).lexically_normal().parent_path().string()),
        output_(fs::absolute(output + "/").lexically_normal().parent_path().string()) {}

  void expand() {
    const std::vector<JobGroup> groups = readJobsFile(path_, problems_);
    if (problems_.empty()) {
      for (const JobGroup& group : groups) {
        expandGroup(group);
      }
    }
  }

  // Hashes every file and reads every log in several threads.
  void checkInputs(int threads, const LogReader& read_log) {
    std::vector<InputFile>& files = manifest_.inputs;
    std::vector<std::string> found(files.size() + readings_.size());
    io::Progress progress("checking inputs", found.size());
    fit::parallelFor(found.size(), threads, [&](std::size_t i) {
      try {
        if (i < files.size()) {
          files[i].content = io::hashFile(files[i].path);
        } else {
          const Reading& reading = readings_[i - files.size()];
          check(reading.job, files[reading.input].path, read_log);
        }
      } catch (const std::exception& error) {
        found[i] = error.what();
      }
      progress.advance();
    });
    std::copy_if(found.begin(), found.end(), std::back_inserter(problems_),
                 [](const std::string& problem) { return !problem.empty(); });
  }

  Expansion finish(const std::string& version) {
    if (!problems_.empty()) {
      return {{}, {}, distinctLines(problems_)};
    }
    manifest_.version = version;
    for (Job& job : manifest_.jobs) {
      job.id = jobId(job, manifest_.inputs, version);
    }
    const std::size_t twice = manifest_.jobs.size() - manifest_.distinctJobs().size();
    if (twice > 0) {
      notes_.push_back(fmt::format("{} jobs are equal to another job and share its result", twice));
    }
    return {std::move(manifest_), std::move(notes_), {}};
  }

 private:
  void problem(const JobGroup& group, const std::string& text) {
    problems_.push_back(fmt::format("{}:{}: jobs.{}.{}", path_, group.line, group.name, text));
  }

  // Returns true for the folder of the campaign and its subfolders, which may exist since an earlier run.
  bool isOwn(const std::string& path) const {
    static const std::vector<std::string> made = {"", "/results", "/reports", "/running", "/slurm"};
    return std::any_of(made.begin(), made.end(), [&](const std::string& name) { return path == output_ + name; });
  }

  // Returns the paths that match. Files with a problem are omitted, because reading them may never end.
  std::vector<std::string> match(const JobGroup& group, const char* key, const std::string& folder,
                                 const std::vector<std::string>& patterns) {
    std::vector<std::string> paths;
    for (const std::string& pattern : patterns) {
      bool matches = false;
      for (const std::string& path : matchPattern(folder, pattern)) {
        if (isOwn(path)) {
          continue;
        }
        matches = true;
        std::error_code ignored;
        if (!log::isUtf8(path)) {
          problem(group, fmt::format("{}: {}: the file name is not UTF-8; accepted: a name in UTF-8", key, path));
        } else if (!fs::is_regular_file(path, ignored) && !fs::is_directory(path, ignored)) {
          problem(group, fmt::format("{}: {}: is a device, pipe or socket; accepted: a file or a folder", key, path));
        } else {
          paths.push_back(path);
        }
      }
      if (!matches) {
        problem(group, fmt::format("{}: {} matches nothing in {}; accepted: a pattern that matches existing files", key,
                                   log::quoted(pattern), folder));
      }
    }
    return paths;
  }

  void expandGroup(const JobGroup& group) {
    if (group.folders.empty()) {
      expandFolder(group, base_, ".");
      return;
    }
    bool matches = false;
    for (const std::string& path : match(group, "folders", base_, {group.folders})) {
      std::error_code ignored;
      if (fs::is_directory(path, ignored)) {
        expandFolder(group, path, fs::path(path).lexically_relative(base_).string());
        matches = true;
      }
    }
    if (!matches) {
      problem(group, fmt::format("folders: {} matches no folder; accepted: a pattern that matches folders",
                                 log::quoted(group.folders)));
    }
  }

  void expandFolder(const JobGroup& group, const std::string& folder, const std::string& name) {
    const std::vector<std::string> configs = match(group, "config", folder, {group.config});
    Place place{name, configs.empty() ? "" : configs.front(), {}};
    for (const std::string& path : match(group, kLog, folder, group.logs)) {
      place.logs.push_back({kLog, path});
    }
    const bool has_logs = !place.logs.empty();
    for (const std::string& path : match(group, kHoldOut, folder, group.hold_out)) {
      place.logs.push_back({kHoldOut, path});
    }
    refuseTwice(group, place.logs);
    if (configs.size() > 1) {
      problem(group, fmt::format("config: {} matches {} files in {}; accepted: a pattern that matches one file",
                                 group.config, configs.size(), folder));
    } else if (configs.size() == 1 && has_logs) {
      expandPlace(group, place);
    }
  }

  // Refuses a log that is given twice. Unless the jobs are replays, also refuses copies of a log under other names.
  void refuseTwice(const JobGroup& group, const std::vector<io::InputFile>& logs) {
    std::set<std::string> seen;
    std::vector<io::InputFile> distinct;
    for (const io::InputFile& log : logs) {
      if (seen.insert(log.path).second) {
        distinct.push_back(log);
      } else {
        problem(group, fmt::format("{}: {} is given twice; accepted: each log once", log.option, log.path));
      }
    }
    try {
      if (group.command != Command::replay) {
        io::refuseEqualLogs(distinct);
      }
    } catch (const io::OutputRefused& error) {
      problem(group, error.what());
    }
  }

  void expandPlace(const JobGroup& group, const Place& place) {
    try {
      const Components& components = load(place.config);
      for (const std::string& name : componentsOf(group, components)) {
        expandComponent(group, place, components, name);
      }
    } catch (const std::exception& error) {
      problems_.emplace_back(error.what());
    }
  }

  // Parses equal files only once, because most files of a fleet are copies.
  const Components& load(const std::string& path) {
    const std::string text = log::readInput(path, io::kMaximumComponentFileSize, "; accepted: a component file");
    const auto known = components_.find(text);
    return known != components_.end() ? known->second
                                      : components_.emplace(text, io::parseComponentFile(text, path)).first->second;
  }

  void expandComponent(const JobGroup& group, const Place& place, const Components& components,
                       const std::string& name) {
    try {
      const io::ComponentDescription component = io::selectComponent(components, name);
      const Job job = jobOf(group, place, component.name);
      if (group.monte_carlo) {
        addDraws(group, job, component);
      } else {
        addJobs(group, job);
      }
    } catch (const std::exception& error) {
      problems_.push_back(fmt::format("{}: {}", place.config, error.what()));
    }
  }

  Job jobOf(const JobGroup& group, const Place& place, const std::string& component) {
    Job job;
    job.group = group.name;
    job.type = group.type.empty() ? component : group.type;
    job.test_rig = group.test_rig;
    job.test_piece = place.name;
    job.command = group.command;
    job.component = component;
    job.options = group.options;
    job.config = inputOf(place.config);
    const Job reader = job;  // the job does not have logs yet
    const nlohmann::ordered_json reading = {job.options, component, job.command == Command::replay};
    for (const auto& [key, path] : place.logs) {
      const std::size_t input = inputOf(path);
      (key == kLog ? job.logs : job.hold_out).push_back(input);
      if (seen_readings_.insert({input, reading}).second) {
        readings_.push_back({input, reader});
      }
    }
    return job;
  }

  // Returns the index of a file in the list of inputs. A new file is appended to the list.
  std::size_t inputOf(const std::string& path) {
    const auto [place, added] = inputs_.emplace(path, manifest_.inputs.size());
    if (added) {
      manifest_.inputs.push_back({path, {}});
    }
    return place->second;
  }

  void addDraws(const JobGroup& group, const Job& job, io::ComponentDescription component) {
    const std::vector<std::map<std::string, double>> draws =
        drawSpecifications(component.written(), *group.monte_carlo);
    std::size_t unsolvable = 0;
    for (std::size_t run = 1; run <= draws.size(); ++run) {
      Job drawn = job;
      drawn.specification = draws[run - 1];
      drawn.test_piece += fmt::format(" draw {}", run);
      estimation::Specification specification = component.written();
      for (const auto& [name, value] : drawn.specification) {
        specification.set(name, value);
      }
      try {
        component.specify(specification);
        addJobs(group, drawn);
      } catch (const std::invalid_argument& error) {
        ++unsolvable;
        if (!group.monte_carlo->leave_out_unsolvable) {
          problem(group, fmt::format("monte_carlo: the specification of run {} has no solution: {}; also accepted: "
                                     "narrower tolerances, or the key unsolvable: leave_out",
                                     run, error.what()));
        }
      }
    }
    if (unsolvable > 0) {
      notes_.push_back(fmt::format("{}: {} of {} drawn specifications have no solution and are omitted", group.name,
                                   unsolvable, draws.size()));
    }
  }

  void addJobs(const JobGroup& group, const Job& job) {
    if (group.command != Command::replay && !group.one_job_per_log) {
      addJob(job);
      return;
    }
    for (const std::size_t log : job.logs) {
      Job one = job;
      one.logs = {log};
      addJob(one);
    }
  }

  void addJob(const Job& job) {
    if (manifest_.jobs.size() < kMaximumJobs) {
      manifest_.jobs.push_back(job);
    } else {
      problems_.push_back(fmt::format("{0}: more than {1} jobs; accepted: at most {1} jobs", path_, kMaximumJobs));
    }
  }

  std::string path_;    // path of the jobs file
  std::string base_;    // folder of the jobs file
  std::string output_;  // folder of the campaign
  Manifest manifest_;
  std::unordered_map<std::string, Components> components_;  // components by the text of their file
  std::unordered_map<std::string, std::size_t> inputs_;     // index of each path
  std::vector<Reading> readings_;
  std::set<std::pair<std::size_t, nlohmann::ordered_json>> seen_readings_;
  std::vector<std::string> notes_;
  std::vector<std::string> problems_;
};

}  // namespace

log::LogFormat logFormat(const JobOptions& options) {
  log::LogFormat format = log::makeLogFormat(options.columns, options.unit, options.sampling_rate, options.decimal,
                                             options.segment, options.bridge, options.sentinel, options.clock);
  format.accept_units = options.accept_units;
  format.large = options.large;
  return format;
}

Expansion makeManifest(const std::string& jobs_file, const std::string& output, const std::string& version, int threads,
                       const LogReader& read_log) {
  Maker maker(jobs_file, output);
  maker.expand();
  maker.checkInputs(threads, read_log);
  return maker.finish(version);
}

}  // namespace rubber_suspension::campaign
