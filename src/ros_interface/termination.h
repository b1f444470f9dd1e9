// Orderly end of a node at SIGINT, SIGTERM and SIGHUP, within a time limit even if a call hangs.
#pragma once

#include <atomic>
#include <thread>

namespace rubber_suspension::ros_interface {

/// Returns true once this process is to end, by a signal or because ROS is being shut down. Long work then ends early.
bool isEnding();

/// From construction on, SIGINT, SIGTERM and SIGHUP only make isEnding() true, so that the main thread can finish its
/// work, unregister the node and return. If that takes more than 5 s, for example because the master hangs, the process
/// ends with status 1. Make the object before any thread is started, because threads inherit the signal mask, and give
/// ROS no handler of its own.
class Termination {
 public:
  Termination();
  ~Termination();

 private:
  void wait();

  std::atomic<bool> finished_{false};
  std::thread thread_;
};

}  // namespace rubber_suspension::ros_interface
