// A campaign as a job array of Slurm, each task of which runs one shard.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "campaign/run.h"
#include "campaign/status.h"

namespace rubber_suspension::campaign {

struct SlurmOptions {
  std::string program;               ///< absolute path of `campaign`, equal on every node
  double shard_minutes = 5.0;        ///< intended run time of an array task: an empty one already takes some seconds
  std::size_t max_running = 0;       ///< largest number of tasks that run at a time; 0: no limit
  std::string partition;             ///< empty: the cluster's default
  int workers = 1;                   ///< parallel jobs in a task, and processors that the task requests
  double job_minutes = kJobMinutes;  ///< time limit of a job; 0: none
};

/// An array that can be submitted.
struct SlurmArray {
  std::size_t shards = 0;  ///< 0: every job has a result, there is nothing to submit
  std::string script;
  std::string note;  ///< how the number of shards was chosen
};

/// Plans an array over the remaining jobs. If no job is done yet, it assumes kAssumedSeconds for each and notes this.
/// The script moves and deletes nothing, so that a task that Slurm requeues after the loss of a node continues where
/// the lost one stopped.
SlurmArray planArray(const Status& status, const std::string& folder, const SlurmOptions& options);

constexpr double kAssumedSeconds = 5.0;  ///< time of a job if none is done yet [s]: a diagnosis of some minutes of log
constexpr std::size_t kMostElements = 1000;  ///< tasks of an array: Slurm's default MaxArraySize is 1001

/// Submits an array by `sbatch` and returns its number. Throws std::runtime_error if an array that was submitted from
/// this folder still waits or runs, or if sbatch or squeue fail.
std::string submitArray(const SlurmArray& array, const std::string& folder);

}  // namespace rubber_suspension::campaign
