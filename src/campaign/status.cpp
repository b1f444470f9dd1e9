// How far a campaign is.
#include "campaign/status.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "campaign/record.h"

namespace rubber_suspension::campaign {
namespace {

std::string countsText(const std::string& name, const JobCounts& counts) {
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

Status statusOf(const Manifest& manifest, const std::string& folder) {
  Status status;
  std::unordered_set<std::string> running;
  for (const RunningRun& run : findRuns(folder)) {
    if (run.silent > kSilentForLong) {
      status.silent_runs.push_back(run);
    } else {
      running.insert(run.ids.begin(), run.ids.end());
    }
  }
  double seconds = 0.0;
  for (const std::size_t place : manifest.distinctJobs()) {
    const Job& job = manifest.jobs[place];
    const FoundRecord found = findRecord(folder, job.id, manifest.version);
    std::size_t JobCounts::*count = running.count(job.id) != 0 ? &JobCounts::running : &JobCounts::missing;
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
    text += countsText(name, counts);
  }
  if (status.by_group.size() > 1) {
    text += countsText("all", status.all);
  }
  text += listText("failed:", status.failures);
  text += listText("broken records, which will be done again:", status.broken);
  std::vector<std::string> silent;
  for (const RunningRun& run : status.silent_runs) {
    silent.push_back(
        fmt::format("{}: silent for {:.0f} s, with {} jobs in its hands", run.where, run.silent, run.ids.size()));
  }
  text += listText("runs that ended without saying so (their jobs count as missing):", silent);
  const std::size_t left = status.all.jobs - status.all.done - status.all.failed;
  if (left > 0 && status.seconds_per_job > 0.0) {
    text += fmt::format("{} jobs left, about {:.3g} min of one worker at {:.3g} s a job\n", left,
                        static_cast<double>(left) * status.seconds_per_job / 60.0, status.seconds_per_job);
  }
  return text;
}

}  // namespace rubber_suspension::campaign
