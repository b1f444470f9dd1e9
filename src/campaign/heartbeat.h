// What runs at the moment: each run keeps a file in the campaign's folder that names the jobs in its hands.
#pragma once

#include <chrono>
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

  /// Names the jobs; writes every few seconds only.
  void beat(const Manifest& manifest, const std::vector<std::size_t>& running);

 private:
  std::string path_;
  std::chrono::steady_clock::time_point last_{};
};

struct RunningRun {
  std::string where;  ///< host and process
  std::vector<std::string> ids;
  double silent = 0.0;  ///< since its last beat [s]
};

/// A run that has been silent for so long [s] is taken for dead; it beats every few seconds.
constexpr double kSilentForLong = 120.0;

/// All runs that have left a file; by the clock of the file system.
std::vector<RunningRun> findRuns(const std::string& folder);

}  // namespace rubber_suspension::campaign
