// Worker processes, each of which executes many jobs, and a supervisor that survives the death of a worker.
//
// Each worker is forked once and calls the library for one job after the other: starting a process for each of 10^5
// small jobs would cost more than the jobs, and a crashing thread would end all others. If a worker dies, its job has
// failed and another worker is forked, so a log that crashes a reader costs one fork and one record.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rubber_suspension::campaign {

/// Outcome of a job.
enum class JobEnd : char {
  done,
  failed,  ///< with an error, which the worker reported
  died,    ///< with its worker, also at the time limit
  left,    ///< not done: out of memory, or killed from outside
};

struct PoolCallbacks {
  /// Called once in each worker process; returns the function that executes a job. This function returns the job's
  /// error, empty if done, and throws std::bad_alloc to leave the job undone. Other exceptions end the run.
  std::function<std::function<std::string(std::size_t job)>()> start_worker;
  /// Called in this process. `reason` is the error, or "the process was ended by signal 11 (Segmentation fault)" etc.
  std::function<void(std::size_t job, JobEnd end, const std::string& reason)> ended;
  /// Called in this process, several times a second, with the running jobs.
  std::function<void(const std::vector<std::size_t>& running)> tick;
};

/// Executes these jobs in order with `workers` processes; returns false, after the workers have ended, if SIGINT,
/// SIGTERM or SIGHUP interrupted it. This process must have no other thread. If a worker is killed from outside
/// (SIGKILL, SIGTERM, ...), its job is tried once more; after a second time (probably for lack of memory), it remains
/// undone.
///
/// A job that takes longer than `longest` [s] is ended with its worker and counts as died; 0: no limit. Time in which
/// this process itself did not run (suspended with its workers, as by a cluster for more urgent work) does not count.
///
/// Throws std::runtime_error if no process can be started or a worker reports an exception.
bool workOff(const std::vector<std::size_t>& jobs, int workers, const PoolCallbacks& callbacks, double longest = 0.0);

}  // namespace rubber_suspension::campaign
