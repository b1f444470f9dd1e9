// A campaign as a job array of Slurm: each element works off one shard.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "campaign/run.h"
#include "campaign/status.h"

namespace rubber_suspension::campaign {

struct SlurmOptions {
  std::string program;               ///< absolute path of `campaign`, which every node has there
  double shard_minutes = 5.0;        ///< of work an element: an empty one already costs some seconds
  std::size_t max_running = 0;       ///< elements at a time; 0: as many as the cluster lets
  std::string partition;             ///< empty: the cluster's default
  int workers = 1;                   ///< jobs at a time in an element, and processors that it asks for
  double job_minutes = kJobMinutes;  ///< limit of time for a job; 0: none
};

/// An array as it would be submitted.
struct SlurmArray {
  std::size_t shards = 0;  ///< 0: every job has a result, nothing is to be submitted
  std::string script;
  std::string note;  ///< how the number of shards came about
};

/// Plans an array over the remaining jobs. If none is done yet, kAssumedSeconds are assumed for each, with a note. The
/// script moves and deletes nothing, so that an element that Slurm requeues after the loss of a node continues where
/// the lost one stopped.
SlurmArray planArray(const Status& status, const std::string& folder, const SlurmOptions& options);

constexpr double kAssumedSeconds = 5.0;      ///< of a job of which nothing is known: a diagnosis of some minutes of log
constexpr std::size_t kMostElements = 1000;  ///< of an array, as Slurm's MaxArraySize of 1001 allows

/// Submits by `sbatch`; returns the number of the array. Where one that was submitted from this folder still waits or
/// runs, nothing is submitted: throws std::runtime_error that names it, as where sbatch or squeue fail.
std::string submitArray(const SlurmArray& array, const std::string& folder);

}  // namespace rubber_suspension::campaign
