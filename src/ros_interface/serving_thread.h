// A thread that serves a group of components from a callback queue of its own, at real-time priority if permitted.
#pragma once

#include <ros/callback_queue.h>

#include <atomic>
#include <string>
#include <thread>

namespace rubber_suspension::ros_interface {

/// Only this thread gets SCHED_FIFO: with every thread of a process at that priority and one processor, the node could
/// not even shut down.
class ServingThread {
 public:
  ServingThread() = default;
  ~ServingThread() { stop(); }
  ServingThread(const ServingThread&) = delete;
  ServingThread& operator=(const ServingThread&) = delete;

  ros::CallbackQueue& queue() { return queue_; }

  /// Start to serve; with a priority above 0 at that SCHED_FIFO priority. Returns why that was not possible, or
  /// nothing. The thread serves in any case.
  std::string start(int realtime_priority);

  /// Finish the callback that runs and end. Callbacks that wait are discarded.
  void stop();

 private:
  void run();

  ros::CallbackQueue queue_;
  std::atomic<bool> running_{false};
  std::thread thread_;
};

/// Keep all memory of this process resident, present and future. Returns why that was not possible, or nothing.
std::string lockMemory();

}  // namespace rubber_suspension::ros_interface
