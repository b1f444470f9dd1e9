// Runs a campaign as a job array of Slurm. Each task of the array runs one shard.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "campaign/run.h"
#include "campaign/status.h"

namespace rubber_suspension::campaign {

struct SlurmOptions {
  std::string program;               ///< absolute path of `campaign`, the same on every node
  double shard_minutes = 5.0;        ///< intended run time of a task; even a task without jobs takes some seconds
  std::size_t max_running = 0;       ///< largest number of tasks that run at a time; 0 for no limit
  std::string partition;             ///< if empty, the default of the cluster
  int workers = 1;                   ///< number of parallel jobs in a task, and of processors that the task requests
  double job_minutes = kJobMinutes;  ///< time limit of a job; 0 for no limit
};

struct SlurmArray {
  std::size_t shards = 0;  ///< 0 if every job has a result, so that there is nothing to submit
  std::string script;
  std::string note;  ///< states how the number of shards was chosen
};

/// Plans an array for the remaining jobs. If no job is done yet, assumes kAssumedSeconds per job and states this in the
/// note. The script neither moves nor deletes files. A task that Slurm requeues after the loss of a node therefore
/// continues where the lost task stopped.
SlurmArray planArray(const Status& status, const std::string& folder, const SlurmOptions& options);

/// Assumed time of a job if no job is done yet [s]; a diagnosis of some minutes of log takes as long.
constexpr double kAssumedSeconds = 5.0;
constexpr std::size_t kMostElements = 1000;  ///< tasks in an array; the default MaxArraySize of Slurm is 1001

/// Submits an array with `sbatch` and returns its number. Throws std::runtime_error if an array that was submitted from
/// this folder still waits or runs, or if sbatch or squeue fails.
std::string submitArray(const SlurmArray& array, const std::string& folder);

}  // namespace rubber_suspension::campaign
