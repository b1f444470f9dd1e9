// The orderly end of a node: the same at SIGINT, SIGTERM and SIGHUP, and soon, even while something hangs.
#pragma once

#include <atomic>
#include <thread>

namespace rubber_suspension::ros_interface {

/// True once this process is to end: by a signal, or because ROS is being shut down. Long work ends early then.
bool isEnding();

/// From its construction on SIGINT, SIGTERM and SIGHUP make isEnding() true, and nothing else: the main thread ends
/// what it has begun, takes the node off the master and returns. Where that is held up for 5 s - a file does not open,
/// the master answers once and then hangs - the process ends with status 1. Make it before any thread is started, as
/// threads inherit which signals they get; give ROS no handler of its own.
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
