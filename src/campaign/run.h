// Runs the jobs of a campaign, or a shard of them. Jobs with a result are skipped. A failure is stored in the record.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "campaign/make.h"
#include "campaign/manifest.h"

namespace rubber_suspension::campaign {

/// Every `count`-th job, beginning with the job of number `index`.
struct Shard {
  std::size_t index = 1;  ///< 1 to `count`
  std::size_t count = 1;

  bool holds(std::size_t place) const { return place % count == index - 1; }
};

/// Parses "3/8", the third of eight shards. Throws std::invalid_argument that states what is accepted.
Shard parseShard(const std::string& text);

/// Default time limit of a job [min]. The limit is meant for jobs that would never end: a diagnosis takes some minutes
/// however long its logs are, because it searches at most 300,000 samples.
constexpr double kJobMinutes = 240.0;

struct RunOptions {
  Shard shard;
  int workers = 1;
  bool retry_failed = false;         ///< runs failed jobs again
  double job_minutes = kJobMinutes;  ///< a job that takes longer counts as failed; 0 for no limit
};

struct RunSummary {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t passed_over = 0;    ///< number of jobs with a result of an earlier run
  std::size_t failed_before = 0;  ///< number of jobs among passed_over that have failed
  std::size_t not_done = 0;       ///< out of memory, or killed from outside; the next run repeats these jobs
  bool interrupted = false;
};

/// Receives each line for the user: broken records whose jobs are run again, failed jobs, and progress.
using Say = std::function<void(const std::string& line)>;

/// Runs the jobs. Throws std::runtime_error if the manifest was made by another version than `version`, or if a file
/// cannot be written. If the disk was full, the next run continues.
RunSummary run(const std::string& folder, const std::string& version, const RunOptions& options,
               const LogReader& read_log, const Say& say);

/// Throws std::runtime_error if the manifest was made by another version of the program.
void requireVersion(const Manifest& manifest, const std::string& folder, const std::string& version);

}  // namespace rubber_suspension::campaign
