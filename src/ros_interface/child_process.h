// Other programs that are started: a master and nodes by a benchmark and by tests.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// A child process that ends with this object.
class ChildProcess {
 public:
  /// Start a program, found on PATH, with its arguments; no shell is involved. Throws std::runtime_error.
  explicit ChildProcess(const std::vector<std::string>& command);
  /// Asks the program to end (SIGINT), and kills it where it does not within some seconds.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool running();
  pid_t id() const { return id_; }

 private:
  pid_t id_ = -1;
};

/// The path of another program that lies beside the running one.
std::string siblingProgram(const std::string& name);

/// A TCP port on the loopback interface that nobody listens on. Throws std::runtime_error.
int freePort();

}  // namespace rubber_suspension::ros_interface
