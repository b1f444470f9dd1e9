// Reports the progress of a campaign from its records and the jobs that are running. Each run lists its current jobs in
// a file in the folder of the campaign, which is informative only and may be deleted.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "campaign/manifest.h"

namespace rubber_suspension::campaign {

class Heartbeat {
 public:
  explicit Heartbeat(const std::string& folder);
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;
  ~Heartbeat();  ///< removes the file

  /// Writes the ids of the running jobs, at most every few seconds.
  void beat(const Manifest& manifest, const std::vector<std::size_t>& running);

 private:
  std::string path_;
  std::chrono::steady_clock::time_point last_{};
};

/// A run without a heartbeat for this time [s] counts as dead. Heartbeats are due every few seconds.
constexpr double kSilentForLong = 120.0;

struct JobCounts {
  std::size_t jobs = 0;  ///< number of distinct ids
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t broken = 0;   ///< records with an error (FoundRecord::problem); their jobs will be run again
  std::size_t running = 0;  ///< jobs that a run lists as current and that have no record
  std::size_t missing = 0;  ///< all other jobs
};

struct Status {
  JobCounts all;
  std::map<std::string, JobCounts> by_group;
  std::vector<std::string> failures;  ///< name and error of each failed job, in the order of the manifest
  std::vector<std::string> broken;
  std::vector<std::string> silent_runs;  ///< runs that stopped sending heartbeats
  double seconds_per_job = 0.0;          ///< mean over the jobs that are done [s]; 0 if none is done
};

/// Reads every record and returns the progress. Throws std::runtime_error.
Status statusOf(const Manifest& manifest, const std::string& folder);

std::string toText(const Status& status);

}  // namespace rubber_suspension::campaign
