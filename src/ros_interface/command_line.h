// Command lines of programs that are ROS nodes: what ROS takes (name:=value) and what the program's own parser gets.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// Splits a command line without contact to a master, so that --help and --version work anywhere.
class RosCommandLine {
 public:
  RosCommandLine(int argc, char** argv);
  ~RosCommandLine() { takeOffParameters(); }
  RosCommandLine(const RosCommandLine&) = delete;
  RosCommandLine& operator=(const RosCommandLine&) = delete;

  /// The arguments that are left for the program, its name first.
  int argc() const { return static_cast<int>(pointers_.size()); }
  char** argv() { return pointers_.data(); }

  /// Initialise ROS with the arguments meant for it and the options of ros::init_options, once the master answers;
  /// false where the process is to end before. Throws std::runtime_error where the arguments or the master's address
  /// are malformed, or no master answers within `timeout` [s].
  bool initialise(const std::string& node_name, std::uint32_t options = 0,
                  double timeout = std::numeric_limits<double>::infinity());

  /// Take the private parameters that the arguments have set (_NAME:=VALUE) off the master again, where they would
  /// otherwise hold for the next process of this name. The destructor does so, too, if the master still answers then.
  void takeOffParameters();

 private:
  bool waitForMaster(double timeout) const;

  bool initialised_ = false;
  std::vector<std::string> all_;
  std::vector<std::string> own_;
  std::vector<char*> pointers_;
};

/// Where the value of a private parameter comes from: "the argument _NAME", say.
std::string originOfParameter(const std::string& name);

}  // namespace rubber_suspension::ros_interface
