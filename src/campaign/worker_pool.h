// Runs worker processes, each of which executes many jobs, and a supervisor that survives the death of a worker.
// A worker is forked once and then calls the library for one job after the other. Starting a process for each of 10^5
// small jobs would cost more than the jobs, and in a single process a crash would end all other jobs. If a worker dies,
// its job has failed and another worker is forked. A log that crashes a reader therefore costs one fork and one record.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rubber_suspension::campaign {

enum class JobEnd : char {
  done,
  failed,  ///< the worker reported an error
  died,    ///< the worker died, or the job exceeded the time limit
  left,    ///< not done, because memory was lacking or the worker was killed from outside
};

struct PoolCallbacks {
  /// Called once in each worker process. Returns the function that executes a job. That function returns the error of
  /// the job, or an empty text, and throws std::bad_alloc to leave the job undone. Other exceptions end the run.
  std::function<std::function<std::string(std::size_t job)>()> start_worker;
  /// Called in this process. `reason` is the error, or a text such as "the process was ended by signal 11 (...)".
  std::function<void(std::size_t job, JobEnd end, const std::string& reason)> ended;
  /// Called in this process several times per second with the running jobs.
  std::function<void(const std::vector<std::size_t>& running)> tick;
};

/// Executes these jobs in order with `workers` processes. Returns false if SIGINT, SIGTERM or SIGHUP interrupted it,
/// after the workers have ended. This process must have no other thread. If a worker is killed from outside (SIGKILL,
/// SIGTERM, ...), its job is tried once more. If its worker is killed again, probably for lack of memory, the job
/// remains undone.
///
/// If a job takes longer than `longest` [s], its worker is killed and the job counts as died; 0 means no limit. Time in
/// which this process did not run does not count, such as when a cluster suspends it together with its workers.
///
/// Throws std::runtime_error if a process cannot be started or a worker reports an exception.
bool workOff(const std::vector<std::size_t>& jobs, int workers, const PoolCallbacks& callbacks, double longest = 0.0);

}  // namespace rubber_suspension::campaign
