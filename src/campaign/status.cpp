// Reports the progress of a campaign.
#include "campaign/status.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "campaign/record.h"

namespace rubber_suspension::campaign {
namespace {

namespace fs = std::filesystem;

constexpr auto kPause = std::chrono::seconds(5);

std::string folderOf(const std::string& folder) { return folder + "/running"; }

std::string hostName() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "host";
}

// Returns the current time of the file system. Its clock may be the clock of another computer.
fs::file_time_type nowThere(const std::string& folder) {
  const std::string probe = fmt::format("{}/.now.{}", folder, getpid());
  std::ofstream(probe) << '\n';
  std::error_code failure;
  const fs::file_time_type now = fs::last_write_time(probe, failure);
  const fs::file_time_type result = failure ? fs::file_time_type::clock::now() : now;
  fs::remove(probe, failure);
  return result;
}

struct RunningRun {
  std::vector<std::string> ids;  // ids of the jobs that are running
  double silent;                 // time since the last heartbeat [s]
};

// Returns all runs that have a heartbeat file, by the name of this file, which states host and process.
std::map<std::string, RunningRun> findRuns(const std::string& folder) {
  std::map<std::string, RunningRun> runs;
  std::error_code failure;
  if (!fs::is_directory(folder, failure)) {
    return runs;
  }
  const fs::file_time_type now = nowThere(folder);
  for (const auto& entry : fs::directory_iterator(folder, failure)) {
    const std::string name = entry.path().filename().string();
    const fs::file_time_type beat = entry.last_write_time(failure);
    if (!failure && name.front() != '.' && entry.path().extension() != ".new") {
      std::ifstream file(entry.path());
      runs[name] = {{std::istream_iterator<std::string>(file), {}}, std::chrono::duration<double>(now - beat).count()};
    }
  }
  return runs;
}

std::string row(const std::string& name, const JobCounts& counts) {
  return fmt::format("  {:<24} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", name, counts.jobs, counts.done, counts.failed,
                     counts.running, counts.broken, counts.missing);
}

std::string listText(const std::string& title, const std::vector<std::string>& lines) {
  constexpr std::size_t kMost = 20;
  std::string text = lines.empty() ? "" : title + "\n";
  for (std::size_t i = 0; i < std::min(kMost, lines.size()); ++i) {
    text += "  " + lines[i] + "\n";
  }
  return text + (lines.size() > kMost ? fmt::format("  and {} more\n", lines.size() - kMost) : "");
}

}  // namespace
Heartbeat::Heartbeat(const std::string& folder)
    : path_(fmt::format("{}/{}.{}", folderOf(folder), hostName(), getpid())) {
  std::error_code ignored;
  fs::create_directories(folderOf(folder), ignored);
}

Heartbeat::~Heartbeat() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

void Heartbeat::beat(const Manifest& manifest, const std::vector<std::size_t>& running) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < kPause) {
    return;
  }
  last_ = now;
  const std::string beside = path_ + ".new";
  std::ofstream file(beside);
  for (const std::size_t job : running) {
    file << manifest.jobs[job].id << '\n';
  }
  file.close();
  std::rename(beside.c_str(), path_.c_str());
}

Status statusOf(const Manifest& manifest, const std::string& folder) {
  Status status;
  std::set<std::string> running;
  for (const auto& [where, run] : findRuns(folderOf(folder))) {
    if (run.silent > kSilentForLong) {
      status.silent_runs.push_back(fmt::format("{}: has not reported for {:.0f} s and left {} jobs unfinished", where,
                                               run.silent, run.ids.size()));
    } else {
      running.insert(run.ids.begin(), run.ids.end());
    }
  }
  double seconds = 0.0;
  for (const std::size_t place : manifest.distinctJobs()) {
    const Job& job = manifest.jobs[place];
    const FoundRecord found = findRecord(folder, job.id, manifest.version, FileCheck::sizes);
    std::size_t JobCounts::* count = running.count(job.id) != 0 ? &JobCounts::running : &JobCounts::missing;
    if (!found.problem.empty()) {
      count = &JobCounts::broken;
      status.broken.push_back(found.problem);
    } else if (found.record && found.record->failed()) {
      count = &JobCounts::failed;
      status.failures.push_back(nameOf(job) + ": " + found.record->error);
    } else if (found.record) {
      count = &JobCounts::done;
      seconds += found.record->seconds;
    }
    for (JobCounts* counts : {&status.all, &status.by_group[job.group]}) {
      ++counts->jobs;
      ++(counts->*count);
    }
  }
  if (status.all.done > 0) {
    status.seconds_per_job = seconds / static_cast<double>(status.all.done);
  }
  return status;
}

std::string toText(const Status& status) {
  std::string text = fmt::format("  {:<24} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "", "jobs", "done", "failed",
                                 "running", "broken", "missing");
  for (const auto& [name, counts] : status.by_group) {
    text += row(name, counts);
  }
  if (status.by_group.size() > 1) {
    text += row("all", status.all);
  }
  text += listText("failed:", status.failures);
  text += listText("broken records, whose jobs will be run again:", status.broken);
  text += listText("runs that no longer report (their unfinished jobs count as missing):", status.silent_runs);
  const std::size_t left = status.all.jobs - status.all.done - status.all.failed;
  if (left > 0 && status.seconds_per_job > 0.0) {
    text += fmt::format("{} jobs remain: about {:.3g} min for one worker, {:.3g} s for each job\n", left,
                        static_cast<double>(left) * status.seconds_per_job / 60.0, status.seconds_per_job);
  }
  return text;
}

}  // namespace rubber_suspension::campaign
