// Works off the jobs of a campaign.
#include "campaign/run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "campaign/execute.h"
#include "campaign/heartbeat.h"
#include "campaign/record.h"
#include "campaign/worker_pool.h"

namespace rubber_suspension::campaign {
namespace {

using Clock = std::chrono::steady_clock;

// How much is done and when the rest will be: on a terminal in place, elsewhere a line now and then.
class RunProgress {
 public:
  RunProgress(std::size_t total, const Say& say)
      : total_(total), say_(say), terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), shown_(start_) {}
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;
  ~RunProgress() { clear(); }

  void advance() { ++done_; }

  void show() {
    const auto now = Clock::now();
    const auto pause = terminal_ ? std::chrono::milliseconds(500) : std::chrono::milliseconds(60000);
    if (now - shown_ < pause) {
      return;
    }
    shown_ = now;
    const std::string line = text(std::chrono::duration<double>(now - start_).count());
    if (terminal_) {
      fmt::print(stderr, "\r\033[K{}", line);
    } else {
      say_(line);
    }
  }

  void clear() const {
    if (terminal_) {
      fmt::print(stderr, "\r\033[K");
    }
  }

 private:
  std::string text(double elapsed) const {
    std::string line = fmt::format("{} of {} jobs", done_, total_);
    if (done_ > 0) {
      line += ", " + remaining(elapsed / static_cast<double>(done_) * static_cast<double>(total_ - done_));
    }
    return line;
  }

  static std::string remaining(double seconds) {
    const auto minutes = static_cast<long>(seconds / 60.0);
    return minutes >= 60
               ? fmt::format("about {} h {} min left", minutes / 60, minutes % 60)
               : fmt::format("about {} min {:.0f} s left", minutes, seconds - 60.0 * static_cast<double>(minutes));
  }

  std::size_t total_;
  const Say& say_;
  bool terminal_;
  Clock::time_point start_;
  Clock::time_point shown_;
  std::size_t done_ = 0;
};

// The jobs of the shard that are to be worked off.
std::vector<std::size_t> jobsToDo(const Manifest& manifest, const std::string& folder, const RunOptions& options,
                                  const Say& say, RunSummary& summary) {
  const std::vector<std::size_t> distinct = manifest.distinctJobs();
  std::vector<std::size_t> jobs;
  for (std::size_t place = 0; place < distinct.size() && (options.most == 0 || jobs.size() < options.most); ++place) {
    if (!options.shard.holds(place)) {
      continue;
    }
    const FoundRecord found = findRecord(folder, manifest.jobs[distinct[place]].id, manifest.version);
    if (found.state == FoundRecord::State::good && !(options.retry_failed && found.record.failed())) {
      ++summary.passed_over;
      continue;
    }
    if (found.state == FoundRecord::State::broken) {
      say(found.problem + "; the job is done again");
    }
    jobs.push_back(distinct[place]);
  }
  return jobs;
}

Record diedRecord(const Job& job, const Manifest& manifest, const std::string& reason) {
  Record record;
  record.id = job.id;
  record.version = manifest.version;
  record.error = reason;
  return record;
}

// 0 where it is none, or too large for a number of shards.
std::size_t wholeNumber(const std::string& text) {
  constexpr std::size_t kMostDigits = 7;
  const bool digits =
      !text.empty() && text.size() <= kMostDigits && text.find_first_not_of("0123456789") == std::string::npos;
  return digits ? std::stoul(text) : 0;
}

}  // namespace

Shard parseShard(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const Shard shard{wholeNumber(text.substr(0, slash)), wholeNumber(text.substr(std::min(slash + 1, text.size())))};
  if (shard.index == 0 || shard.index > shard.count) {
    throw std::invalid_argument("'" + text + "'; accepted: I/N with whole numbers, I from 1 to N, such as 3/8");
  }
  return shard;
}

void requireVersion(const Manifest& manifest, const std::string& folder, const std::string& version) {
  if (manifest.version != version) {
    throw std::runtime_error(
        fmt::format("{}: of version {}, and this is {}; accepted: `campaign make` again, or that "
                    "version of the program",
                    manifestPath(folder), manifest.version, version));
  }
}

RunSummary run(const std::string& folder, const std::string& version, const RunOptions& options,
               const LogReader& read_log, const Say& say) {
  const Manifest manifest = readManifest(folder);
  requireVersion(manifest, folder, version);
  RunSummary summary;
  const std::vector<std::size_t> jobs = jobsToDo(manifest, folder, options, say, summary);
  RunProgress progress(jobs.size(), say);
  Heartbeat heartbeat(folder);
  const auto failed = [&](std::size_t job, const std::string& error) {
    ++summary.failed;
    progress.clear();
    say(nameOf(manifest.jobs[job]) + ": failed: " + error);
  };
  PoolCallbacks callbacks;
  callbacks.start_worker = [&] {
    const auto executor = std::make_shared<Executor>(folder, manifest, read_log);
    return [executor, &manifest](std::size_t job) { return !executor->execute(manifest.jobs[job]).failed(); };
  };
  callbacks.finished = [&](std::size_t job, bool done) {
    if (done) {
      ++summary.done;
    } else {
      failed(job, findRecord(folder, manifest.jobs[job].id, manifest.version, false).record.error);
    }
    progress.advance();
  };
  callbacks.died = [&](std::size_t job, const std::string& reason) {
    writeRecord(diedRecord(manifest.jobs[job], manifest, reason), folder);
    failed(job, reason);
    progress.advance();
  };
  callbacks.tick = [&](const std::vector<std::size_t>& running) {
    heartbeat.beat(manifest, running);
    progress.show();
  };
  summary.interrupted = workOff(jobs, options.workers, callbacks, 60.0 * options.job_minutes) == PoolEnd::interrupted;
  return summary;
}

}  // namespace rubber_suspension::campaign
