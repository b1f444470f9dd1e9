// Worker processes that work off jobs, each many of them, and a supervisor that outlives what kills a worker.
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

struct PoolCallbacks {
  /// In a worker process, once after the fork: gives what works off a job and returns true where it is done, false
  /// where it failed; what it has to say it writes to files. std::bad_alloc leaves the job undone; any other exception
  /// ends the run, told as `error`.
  std::function<std::function<bool(std::size_t job)>()> start_worker;
  /// In this process: a job is done, or has failed, as the worker said.
  std::function<void(std::size_t job, bool done)> finished;
  /// In this process: a worker died of a job, or was ended at its limit of time. `reason` says how, "the process
  /// died of signal 11 (Segmentation fault)".
  std::function<void(std::size_t job, const std::string& reason)> died;
  /// In this process: a job was left undone, for what the machine lacks or did.
  std::function<void(std::size_t job, const std::string& reason)> left;
  /// In this process, at least once a second, with the jobs that are being worked on.
  std::function<void(const std::vector<std::size_t>& running)> tick;
};

enum class PoolEnd {
  finished,     ///< every job was worked off
  interrupted,  ///< by SIGINT, SIGTERM or SIGHUP; the workers have ended
};

/// Work off these jobs in their order with so many processes. To be called where this process has no other thread. A
/// worker killed from outside (SIGKILL, SIGTERM, ...) speaks against its machine, not against the job, which is tried
/// once more; killed twice (memory, most likely), it is left undone.
///
/// A job that takes longer than `longest` [s] is ended with its worker and counts as died of it, at once; 0: there is
/// no limit. Time in which this process itself did not run (suspended with its workers, as a cluster does for more
/// urgent work) does not count.
///
/// Throws std::runtime_error where no process can be made, or a worker reports an exception.
PoolEnd workOff(const std::vector<std::size_t>& jobs, int workers, const PoolCallbacks& callbacks,
                double longest = 0.0);

}  // namespace rubber_suspension::campaign
