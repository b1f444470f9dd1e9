// From a jobs file to a manifest.
#include "campaign/make.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "campaign/jobs_file.h"
#include "campaign/path_pattern.h"
#include "campaign/tolerance_draws.h"
#include "fit/parallel.h"
#include "io/output_files.h"
#include "io/progress.h"
#include "io/sha256.h"
#include "log/text.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::campaign {
namespace {

namespace fs = std::filesystem;

using Components = std::vector<io::ComponentDescription>;

// What is wrong, each once, in the order in which it was found.
class Problems {
 public:
  void add(const std::string& problem) {
    const std::string line = log::oneLine(problem);
    if (seen_.insert(line).second) {
      lines_.push_back(line);
    }
  }

  bool empty() const { return lines_.empty(); }
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::set<std::string> seen_;
  std::vector<std::string> lines_;
};

// The files of a campaign, each once.
class InputList {
 public:
  std::size_t indexOf(const std::string& path) {
    const auto [place, added] = places_.emplace(path, files_.size());
    if (added) {
      files_.push_back({path, "", 0});
    }
    return place->second;
  }

  std::vector<InputFile>& files() { return files_; }

 private:
  std::unordered_map<std::string, std::size_t> places_;
  std::vector<InputFile> files_;
};

// Component files; those of one content are parsed once, because a fleet mostly has copies of one.
class ComponentFiles {
 public:
  // Nothing, and a problem, where a file is refused.
  std::shared_ptr<const Components> load(const std::string& path, Problems& problems) {
    const auto known = by_path_.find(path);
    if (known != by_path_.end()) {
      return known->second;
    }
    std::shared_ptr<const Components> result;
    try {
      const std::string text = log::readFile(path, io::kMaximumComponentFileSize);
      std::shared_ptr<const Components>& parsed = by_content_[io::sha256(text)];
      if (!parsed) {
        parsed = std::make_shared<const Components>(io::parseComponentFile(text, path));
      }
      result = parsed;
    } catch (const io::ComponentFileError& error) {
      problems.add(error.what());
    } catch (const std::exception& error) {
      problems.add(path + ": " + error.what() + "; accepted: a component file");
    }
    return by_path_[path] = result;
  }

 private:
  std::unordered_map<std::string, std::shared_ptr<const Components>> by_path_;
  std::unordered_map<std::string, std::shared_ptr<const Components>> by_content_;
};

// A log as a group of jobs reads it.
struct LogCheck {
  std::size_t input;
  std::string component;
  JobOptions options;
  bool needs_force;
};

// What one folder of a group holds.
struct Place {
  std::string folder;  // absolute
  std::string name;    // relative to the jobs file's, as users know it
  std::string config;
  std::vector<std::string> logs;
  std::vector<std::string> hold_out;
};

class Maker {
 public:
  Maker(JobsFile file, const std::string& output)
      : file_(std::move(file)),
        base_(fs::absolute(file_.path).lexically_normal().parent_path().string()),
        output_(fs::absolute(output + "/").lexically_normal().parent_path().string()) {}

  void expand() {
    for (const JobGroup& group : file_.groups) {
      expandGroup(group);
    }
  }

  // Reads and hashes every file; the logs by several threads.
  void checkInputs(int threads, const LogReader& read_log) {
    std::vector<InputFile>& files = inputs_.files();
    std::vector<std::string> found(files.size() + checks_.size());
    io::Progress progress("checking inputs", found.size());
    fit::parallelFor(files.size(), threads, [&](std::size_t i) {
      found[i] = hashInput(files[i]);
      progress.advance();
    });
    fit::parallelFor(checks_.size(), threads, [&](std::size_t i) {
      found[files.size() + i] = checkLog(checks_[i], read_log);
      progress.advance();
    });
    for (const std::string& problem : found) {
      if (!problem.empty()) {
        problems_.add(problem);
      }
    }
  }

  Expansion finish(const std::string& version) {
    if (!problems_.empty()) {
      throw BadInputs(problems_.lines());
    }
    Expansion result;
    result.manifest.version = version;
    result.manifest.inputs = std::move(inputs_.files());
    result.manifest.jobs = std::move(jobs_);
    for (Job& job : result.manifest.jobs) {
      job.id = jobId(job, result.manifest.inputs, version);
    }
    result.notes = std::move(notes_);
    const std::size_t twice = result.manifest.jobs.size() - result.manifest.distinctJobs().size();
    if (twice > 0) {
      result.notes.push_back(fmt::format("{} jobs have inputs and options of another one and share its result", twice));
    }
    return result;
  }

 private:
  void problem(const JobGroup& group, const std::string& text) {
    problems_.add(fmt::format("{}:{}: jobs.{}.{}", file_.path, group.line, group.name, text));
  }

  // The campaign's folder and those that it makes in it, which an earlier run may have left there.
  bool isOwn(const std::string& path) const {
    static const std::vector<std::string> made = {"", "/results", "/reports", "/running", "/slurm"};
    return std::any_of(made.begin(), made.end(), [&](const std::string& name) { return path == output_ + name; });
  }

  std::vector<std::string> match(const JobGroup& group, const char* key, const std::string& folder,
                                 const std::string& pattern) {
    std::vector<std::string> paths = matchPattern(folder, pattern);
    paths.erase(std::remove_if(paths.begin(), paths.end(), [&](const std::string& path) { return isOwn(path); }),
                paths.end());
    if (paths.empty()) {
      problem(group, fmt::format("{}: {} matches nothing in {}; accepted: a pattern of existing files", key,
                                 log::quoted(pattern), folder));
    }
    const auto is_bad = [&](const std::string& path) {
      const std::string wrong = problemOf(path);
      if (!wrong.empty()) {
        problem(group, fmt::format("{}: {}: {}", key, path, wrong));
      }
      return !wrong.empty();
    };
    paths.erase(std::remove_if(paths.begin(), paths.end(), is_bad), paths.end());  // which may never end
    return paths;
  }

  static std::string problemOf(const std::string& path) {
    std::error_code ignored;
    if (!log::isUtf8(path)) {
      return "the name is no UTF-8; accepted: another name";
    }
    return std::filesystem::is_regular_file(path, ignored) || std::filesystem::is_directory(path, ignored)
               ? ""
               : "neither a file nor a folder; accepted: these";
  }

  std::vector<std::string> matchAll(const JobGroup& group, const char* key, const std::string& folder,
                                    const std::vector<std::string>& patterns) {
    std::vector<std::string> paths;
    for (const std::string& pattern : patterns) {
      const std::vector<std::string> found = match(group, key, folder, pattern);
      paths.insert(paths.end(), found.begin(), found.end());
    }
    return paths;
  }

  void expandGroup(const JobGroup& group) {
    if (group.folders.empty()) {
      expandFolder(group, base_, ".");
      return;
    }
    std::size_t folders = 0;
    for (const std::string& path : match(group, "folders", base_, group.folders)) {
      std::error_code ignored;
      if (fs::is_directory(path, ignored)) {
        expandFolder(group, path, fs::path(path).lexically_relative(base_).string());
        ++folders;
      }
    }
    if (folders == 0) {
      problem(group,
              fmt::format("folders: {} matches no folder; accepted: a pattern of folders", log::quoted(group.folders)));
    }
  }

  void expandFolder(const JobGroup& group, const std::string& folder, const std::string& name) {
    const std::vector<std::string> configs = match(group, "config", folder, group.config);
    Place place{folder, name, "", matchAll(group, "log", folder, group.logs),
                matchAll(group, "hold_out", folder, group.hold_out)};
    refuseTwice(group, place);
    if (configs.size() > 1) {
      problem(group, fmt::format("config: {} matches {} files in {}; accepted: a pattern of one", group.config,
                                 configs.size(), folder));
    }
    if (configs.size() != 1 || place.logs.empty()) {
      return;
    }
    place.config = configs.front();
    const auto components = files_.load(place.config, problems_);
    if (!components) {
      return;
    }
    for (const std::string& component : componentsOf(group, *components)) {
      try {
        expandComponent(group, place, io::selectComponent(*components, component));
      } catch (const std::exception& error) {
        problems_.add(fmt::format("{}: {}", place.config, error.what()));
      }
    }
  }

  void refuseTwice(const JobGroup& group, const Place& place) {
    std::set<std::string> seen;
    for (const auto& [key, paths] : {std::pair("log", &place.logs), std::pair("hold_out", &place.hold_out)}) {
      for (const std::string& path : *paths) {
        if (!seen.insert(path).second) {
          problem(group, fmt::format("{}: {} is named twice; accepted: once", key, path));
        }
      }
    }
  }

  static std::vector<std::string> componentsOf(const JobGroup& group, const Components& components) {
    if (group.components != std::vector<std::string>{"*"}) {
      return group.components.empty() ? std::vector<std::string>{""} : group.components;
    }
    std::vector<std::string> names;
    for (const io::ComponentDescription& component : components) {
      names.push_back(component.name);
    }
    return names;
  }

  void expandComponent(const JobGroup& group, const Place& place, const io::ComponentDescription& component) {
    Job job;
    job.group = group.name;
    job.type = group.type.empty() ? component.name : group.type;
    job.test_rig = group.test_rig;
    job.test_piece = place.name;
    job.command = group.command;
    job.component = component.name;
    job.options = group.options;
    job.config = inputs_.indexOf(place.config);
    const std::string reading =
        fmt::format("{}\n{}\n{}", job.component, job.command != Command::replay, readingKey(job.options));
    if (group.command != Command::replay) {
      refuseCopies(group, place);
    }
    for (const std::string& path : place.logs) {
      job.logs.push_back(addLog(path, job, reading));
    }
    for (const std::string& path : place.hold_out) {
      job.hold_out.push_back(addLog(path, job, reading));
    }
    if (!group.monte_carlo) {
      addJobs(group, job);
      return;
    }
    addDraws(group, job, component);
  }

  void refuseCopies(const JobGroup& group, const Place& place) {
    std::set<std::string> seen;  // the same name twice is told already
    std::vector<io::InputFile> logs;
    for (const auto& [key, paths] : {std::pair("log", &place.logs), std::pair("hold_out", &place.hold_out)}) {
      for (const std::string& path : *paths) {
        if (seen.insert(path).second) {
          logs.push_back({key, path});
        }
      }
    }
    try {
      io::refuseEqualLogs(logs);
    } catch (const io::OutputRefused& error) {
      problem(group, error.what());
    }
  }

  void addDraws(const JobGroup& group, const Job& job, const io::ComponentDescription& component) {
    io::ComponentDescription drawn = component;
    std::size_t unsolvable = 0;
    std::size_t run = 0;
    for (const auto& numbers : drawSpecifications(component.written(), *group.monte_carlo)) {
      ++run;
      estimation::Specification specification = component.written();
      for (const auto& [name, value] : numbers) {
        specification.set(name, value);
      }
      try {
        drawn.specify(specification);
      } catch (const std::invalid_argument& error) {
        ++unsolvable;
        if (!group.monte_carlo->leave_out_unsolvable) {
          problem(group, fmt::format("monte_carlo: run {} has no solution: {}; or narrower tolerances, or unsolvable: "
                                     "leave_out",
                                     run, error.what()));
        }
        continue;
      }
      Job one = job;
      one.specification = numbers;
      one.test_piece += fmt::format(" draw {}", run);
      addJobs(group, one);
    }
    if (unsolvable > 0 && group.monte_carlo->leave_out_unsolvable) {
      notes_.push_back(
          fmt::format("{}: {} of {} draws have no solution and are left out", group.name, unsolvable, run));
    }
  }

  // One job for all logs, or one each.
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
    if (jobs_.size() == kMaximumJobs) {
      problems_.add(fmt::format("{}: more than {} jobs; accepted: that many at most", file_.path, kMaximumJobs));
      return;
    }
    jobs_.push_back(job);
  }

  // `reading` is how it will be read: each way is checked once.
  std::size_t addLog(const std::string& path, const Job& job, const std::string& reading) {
    const std::size_t input = inputs_.indexOf(path);
    if (check_keys_.insert(fmt::format("{}\n{}", input, reading)).second) {
      checks_.push_back({input, job.component, job.options, job.command != Command::replay});
    }
    return input;
  }

  static std::string hashInput(InputFile& file) {
    try {
      const io::FileHash hash = io::hashFile(file.path);
      file.sha256 = hash.sha256;
      file.size = hash.size;
      return "";
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  std::string checkLog(const LogCheck& check, const LogReader& read_log) {
    const std::string& path = inputs_.files()[check.input].path;
    try {
      const log::Log log = read_log(path, check.component, logFormat(check.options));
      return check.needs_force && log.force.empty()
                 ? path + ": has no measured force; accepted: a log with a column of the measured force"
                 : "";
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  JobsFile file_;
  std::string base_;    // folder of the jobs file
  std::string output_;  // the campaign's own folder
  ComponentFiles files_;
  InputList inputs_;
  std::vector<LogCheck> checks_;
  std::unordered_set<std::string> check_keys_;
  std::vector<Job> jobs_;
  std::vector<std::string> notes_;
  Problems problems_;
};

std::string summaryOf(const std::vector<std::string>& problems) {
  return problems.size() == 1 ? problems.front() : fmt::format("{} problems, nothing was made", problems.size());
}

}  // namespace

BadInputs::BadInputs(std::vector<std::string> problems)
    : std::runtime_error(summaryOf(problems)), problems_(std::move(problems)) {}

std::string readingKey(const JobOptions& options) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", log::join(options.columns), options.unit, options.sampling_rate,
                     options.decimal, options.segment, options.bridge, options.accept_units);
}

log::LogFormat logFormat(const JobOptions& options) {
  log::LogFormat format = log::makeLogFormat(options.columns, options.unit, options.sampling_rate, options.decimal,
                                             options.segment, options.bridge);
  format.accept_units = options.accept_units;
  return format;
}

Expansion makeManifest(const std::string& jobs_file, const std::string& output, const std::string& version, int threads,
                       const LogReader& read_log) {
  std::vector<std::string> problems;
  JobsFile file = readJobsFile(jobs_file, problems);
  if (!problems.empty()) {
    throw BadInputs(problems);
  }
  Maker maker(std::move(file), output);
  maker.expand();
  maker.checkInputs(threads, read_log);
  return maker.finish(version);
}

}  // namespace rubber_suspension::campaign
