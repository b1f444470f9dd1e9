// Works off the jobs of a campaign, or a shard of them: what is done is passed over, what fails is a record.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "campaign/make.h"
#include "campaign/manifest.h"

namespace rubber_suspension::campaign {

/// Every `count`-th job, from the `index`-th on.
struct Shard {
  std::size_t index = 1;  ///< from 1
  std::size_t count = 1;

  bool holds(std::size_t place) const { return place % count == index - 1; }
};

/// "3/8" is the third of eight shards. Throws std::invalid_argument that says what is accepted.
Shard parseShard(const std::string& text);

/// Default time limit of a job [min]. It only ends jobs that would never end: a diagnosis searches at most 300,000
/// samples, in some minutes, however long its logs are.
constexpr double kJobMinutes = 240.0;

struct RunOptions {
  Shard shard;
  int workers = 1;
  bool retry_failed = false;         ///< work failed jobs off again
  double job_minutes = kJobMinutes;  ///< a job that takes longer has failed; 0: there is no limit
};

struct RunSummary {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t passed_over = 0;    ///< that were done or failed before
  std::size_t failed_before = 0;  ///< of those passed over
  std::size_t not_done = 0;       ///< for lack of memory, or killed from outside; the next run tries them again
  bool interrupted = false;
};

/// Receives each line for the user: broken records that are done again, failed jobs, and now and then the progress.
using Say = std::function<void(const std::string& line)>;

/// Throws std::runtime_error where the manifest is of another version than `version`, or nothing can be written: a full
/// disk ends the run, and the next one continues.
RunSummary run(const std::string& folder, const std::string& version, const RunOptions& options,
               const LogReader& read_log, const Say& say);

/// Throws std::runtime_error where a manifest was made by another version of the program than this.
void requireVersion(const Manifest& manifest, const std::string& folder, const std::string& version);

}  // namespace rubber_suspension::campaign
