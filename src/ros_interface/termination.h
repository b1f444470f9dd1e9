// The orderly end of a node: the same at SIGINT, SIGTERM and SIGHUP, and soon, even while something hangs.
#pragma once

#include <atomic>
#include <thread>

namespace rubber_suspension::ros_interface {

/// From its construction on this process ends in order at SIGINT, SIGTERM and SIGHUP: ROS is shut down, the node takes
/// itself off the master, and the exit status is 0. Where that is held up - the master hangs, a file does not open -
/// the process ends all the same: at once if the master does not answer, else after some seconds. Make it before any
/// thread is started, as threads inherit which signals they get; give ROS no handler of its own.
class Termination {
 public:
  Termination();
  ~Termination();
  Termination(const Termination&) = delete;
  Termination& operator=(const Termination&) = delete;

 private:
  void wait();

  std::atomic<bool> finished_{false};
  std::thread thread_;
};

}  // namespace rubber_suspension::ros_interface
