// Command lines of ROS nodes: arguments of ROS (name:=value) and arguments for the program's own parser.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// Splits a command line. This needs no master, so that --help and --version work anywhere.
class RosCommandLine {
 public:
  RosCommandLine(int argc, char** argv);
  ~RosCommandLine() { takeOffParameters(); }
  RosCommandLine(const RosCommandLine&) = delete;
  RosCommandLine& operator=(const RosCommandLine&) = delete;

  /// Returns the number of arguments for the program, its name included.
  int argc() const { return static_cast<int>(pointers_.size()); }
  char** argv() { return pointers_.data(); }

  /// Waits for the master and initialises ROS with its arguments and `options` (ros::init_options). Returns false if
  /// the process is to end before the master answers. Throws std::runtime_error if the arguments or the master's
  /// address are malformed, or no master answers within `timeout` [s].
  bool initialise(const std::string& node_name, std::uint32_t options = 0,
                  double timeout = std::numeric_limits<double>::infinity());

  /// Deletes from the master the private parameters that the arguments have set (_NAME:=VALUE). Otherwise they would
  /// apply to the next process of this name. The destructor also deletes them if the master still answers.
  void takeOffParameters();

 private:
  bool waitForMaster(double timeout) const;

  bool initialised_ = false;
  std::vector<std::string> all_;
  std::vector<std::string> own_;
  std::vector<char*> pointers_;
};

/// Returns where the value of a private parameter comes from, such as "the argument _NAME".
std::string originOfParameter(const std::string& name);

}  // namespace rubber_suspension::ros_interface
