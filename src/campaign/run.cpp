// Runs the jobs of a campaign.
#include "campaign/run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <stdexcept>

#include "campaign/execute.h"
#include "campaign/record.h"
#include "campaign/status.h"
#include "campaign/worker_pool.h"
#include "element/refuse.h"

namespace rubber_suspension::campaign {
namespace {

// Shows progress and remaining time: on a terminal in one line that is overwritten, otherwise in one line per minute.
class RunProgress {
 public:
  RunProgress(std::size_t total, const Say& say) : total_(total), say_(say) {}

  void advance() { ++done_; }

  void show() {
    const auto now = Clock::now();
    if (now - shown_ < (terminal_ ? std::chrono::milliseconds(500) : std::chrono::minutes(1))) {
      return;
    }
    shown_ = now;
    std::string line = fmt::format("{} of {} jobs", done_, total_);
    if (done_ > 0) {
      const double minutes = std::chrono::duration<double>(now - start_).count() / 60.0;
      const double left = minutes / static_cast<double>(done_) * static_cast<double>(total_ - done_);
      line += fmt::format(", about {:.3g} min left", left);
    }
    if (terminal_) {
      fmt::print(stderr, "\r\033[K{}", line);
    } else {
      say_(line);
    }
  }

  void clear() const { fmt::print(stderr, "{}", terminal_ ? "\r\033[K" : ""); }

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t total_;
  const Say& say_;
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
  std::size_t done_ = 0;
};

std::vector<std::size_t> jobsToDo(const Manifest& manifest, const std::string& folder, const RunOptions& options,
                                  const Say& say, RunSummary& summary) {
  const std::vector<std::size_t> distinct = manifest.distinctJobs();
  std::vector<std::size_t> jobs;
  for (std::size_t place = 0; place < distinct.size(); ++place) {
    if (!options.shard.holds(place)) {
      continue;
    }
    const FoundRecord found =
        findRecord(folder, manifest.jobs[distinct[place]].id, manifest.version, FileCheck::digests);
    if (found.record && !(options.retry_failed && found.record->failed())) {
      ++summary.passed_over;
      summary.failed_before += found.record->failed() ? 1 : 0;
      continue;
    }
    if (!found.problem.empty()) {
      say(found.problem + "; the job is run again");
    }
    jobs.push_back(distinct[place]);
  }
  return jobs;
}

}  // namespace

Shard parseShard(const std::string& text) {
  Shard shard{0, 0};
  const char* const end = text.data() + text.size();
  const char* const slash = std::from_chars(text.data(), end, shard.index).ptr;
  const bool complete = slash != end && *slash == '/' && std::from_chars(slash + 1, end, shard.count).ptr == end;
  element::refuseIf(!complete || shard.index == 0 || shard.index > shard.count,
                    "'{}' is not a shard; accepted: I/N with whole numbers, I from 1 to N, such as 3/8", text);
  return shard;
}

void requireVersion(const Manifest& manifest, const std::string& folder, const std::string& version) {
  element::refuseIf<std::runtime_error>(manifest.version != version,
                                        "{}: was written by version {}, but this program has version {}; accepted: "
                                        "`campaign make` again, or the program of the older version",
                                        manifestPath(folder), manifest.version, version);
}

RunSummary run(const std::string& folder, const std::string& version, const RunOptions& options,
               const LogReader& read_log, const Say& say) {
  const Manifest manifest = readManifest(folder);
  requireVersion(manifest, folder, version);
  RunSummary summary;
  const std::vector<std::size_t> jobs = jobsToDo(manifest, folder, options, say, summary);
  RunProgress progress(jobs.size(), say);
  Heartbeat heartbeat(folder);
  PoolCallbacks callbacks;
  callbacks.start_worker = [&] {
    return [&manifest, execute = executorOf(folder, manifest, read_log)](std::size_t job) {
      return execute(manifest.jobs[job]).error;
    };
  };
  callbacks.ended = [&](std::size_t place, JobEnd end, const std::string& reason) {
    const Job& job = manifest.jobs[place];
    progress.advance();
    if (end == JobEnd::done) {
      ++summary.done;
      return;
    }
    if (end == JobEnd::died) {
      writeRecord({job.id, manifest.version, reason}, folder);
    }
    const bool left = end == JobEnd::left;
    ++(left ? summary.not_done : summary.failed);
    progress.clear();
    say(nameOf(job) + (left ? ": not done: " + reason + "; the next run repeats the job" : ": failed: " + reason));
  };
  callbacks.tick = [&](const std::vector<std::size_t>& running) {
    heartbeat.beat(manifest, running);
    progress.show();
  };
  summary.interrupted = !workOff(jobs, options.workers, callbacks, 60.0 * options.job_minutes);
  progress.clear();
  return summary;
}

}  // namespace rubber_suspension::campaign
