// Child processes, with which a benchmark and tests start a master and nodes.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// A child process that ends with this object.
class ChildProcess {
 public:
  /// Starts a program that is on PATH, with its arguments and without a shell. Throws std::runtime_error.
  explicit ChildProcess(const std::vector<std::string>& command);
  /// Asks the program to end (SIGINT) and kills it if it still runs after 5 s.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool running();
  pid_t id() const { return id_; }

 private:
  pid_t id_ = -1;
};

/// Returns the path of a program in the folder of the running program.
std::string siblingProgram(const std::string& name);

/// Returns a free TCP port of the loopback interface. Throws std::runtime_error.
int freePort();

}  // namespace rubber_suspension::ros_interface
