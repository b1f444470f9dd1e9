// Orderly end of a node at SIGINT, SIGTERM and SIGHUP, within a time limit even if a call hangs.
#pragma once

#include <atomic>
#include <thread>

namespace rubber_suspension::ros_interface {

/// Returns true once this process is to end, after a signal or because ROS is being shut down. Long work checks this.
bool isEnding();

/// While this object exists, SIGINT, SIGTERM and SIGHUP only make isEnding() return true, so that the main thread can
/// finish its work, unregister the node and return. If that takes more than 5 s, for example because the master hangs,
/// the process ends with status 1. Construct the object before any thread starts, because threads inherit the signal
/// mask, and do not let ROS install its own handler of SIGINT.
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
