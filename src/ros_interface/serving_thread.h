// A thread that serves a group of components from a callback queue of its own, at real-time priority if permitted.
#pragma once

#include <ros/callback_queue.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

namespace rubber_suspension::ros_interface {

/// Executes the callbacks of its queue. Only serving threads get SCHED_FIFO. If all threads of the process had that
/// priority, a node on a computer with one processor could not even shut down.
class ServingThread {
 public:
  ServingThread() = default;
  ~ServingThread() { stop(); }

  ros::CallbackQueue& queue() { return queue_; }

  /// Starts the thread under a name of at most 15 characters. A priority above 0 becomes its SCHED_FIFO priority.
  /// Returns the reason if the priority could not be set, or an empty text. The thread serves in either case.
  std::string start(const std::string& name, int realtime_priority);

  const std::string& name() const { return name_; }

  /// Returns the time since the last turn of the thread [s], which is about 0.1 s at most unless the thread is blocked.
  double silence() const;

  /// Finishes the running callback and ends the thread. Callbacks that wait are discarded.
  void stop();

 private:
  using Clock = std::chrono::steady_clock;

  void run();

  std::string name_;
  ros::CallbackQueue queue_;
  std::atomic<Clock::time_point> last_round_{};
  std::atomic<bool> running_{false};
  std::thread thread_;
};

/// Keeps all memory of this process resident: present memory at once, and later memory from its first access on, so
/// that allocated but unused memory costs nothing. Returns the reason of a failure, or an empty text.
std::string lockMemory();

}  // namespace rubber_suspension::ros_interface
