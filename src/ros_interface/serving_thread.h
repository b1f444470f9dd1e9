// A thread that serves a group of components from a callback queue of its own, at real-time priority if permitted.
#pragma once

#include <ros/callback_queue.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

namespace rubber_suspension::ros_interface {

/// Only this thread gets SCHED_FIFO: with every thread of a process at that priority and one processor, the node could
/// not even shut down.
class ServingThread {
 public:
  ServingThread() = default;
  ~ServingThread() { stop(); }

  ros::CallbackQueue& queue() { return queue_; }

  /// Start to serve under a name of at most 15 characters; with a priority above 0 at that SCHED_FIFO priority. Returns
  /// why that was not possible, or nothing. The thread serves in any case.
  std::string start(const std::string& name, int realtime_priority);

  const std::string& name() const { return name_; }

  /// Since the thread last came round [s]; it does so at least ten times a second unless something holds it up.
  double silence() const;

  /// Finish the callback that runs and end. Callbacks that wait are discarded.
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

/// Keep all memory of this process resident: what it has now, and what it gets from when it is first touched, so that
/// memory which a message only claims to need takes nothing. Returns why that was not possible, or nothing.
std::string lockMemory();

}  // namespace rubber_suspension::ros_interface
