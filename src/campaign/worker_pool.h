// Worker processes, each of which does many jobs, and a supervisor that survives the death of a worker.
//
// Neither a process per job nor a thread per worker: a process started for each of 10^5 small jobs would cost more than
// the jobs, and a thread that crashes takes all others with it. So each worker is a process, forked once, that calls
// the library for one job after the other; where one dies, the job that it worked on has failed and another worker is
// forked in its place. A log that crashes a reader costs one fork and one record.
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
  died,    ///< together with its worker, also at the limit of time
  left,    ///< undone, for what the machine lacks or did
};

struct PoolCallbacks {
  /// In a worker process, once after the fork: gives what works off a job. That returns the job's error, empty where it
  /// is done, and throws std::bad_alloc to leave the job undone. Any other exception ends the run.
  std::function<std::function<std::string(std::size_t job)>()> start_worker;
  /// In this process: `reason` is the error, "the process died of signal 11 (Segmentation fault)" or the like.
  std::function<void(std::size_t job, JobEnd end, const std::string& reason)> ended;
  /// In this process, several times a second, with the jobs that are being worked on.
  std::function<void(const std::vector<std::size_t>& running)> tick;
};

/// Executes these jobs in order with `workers` processes; returns false, after the workers have ended, if SIGINT,
/// SIGTERM or SIGHUP interrupted it. To be called where this process has no other thread. A worker killed from outside
/// (SIGKILL, SIGTERM, ...) is a fault of the machine, not of the job, which is tried once more; killed twice (probably
/// for memory), it remains undone.
///
/// A job that takes longer than `longest` [s] is ended with its worker and counts as died; 0: no limit. Time in which
/// this process itself did not run (suspended with its workers, as by a cluster for more urgent work) does not count.
///
/// Throws std::runtime_error where no process can be made, or a worker reports an exception.
bool workOff(const std::vector<std::size_t>& jobs, int workers, const PoolCallbacks& callbacks, double longest = 0.0);

}  // namespace rubber_suspension::campaign
