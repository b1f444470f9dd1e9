// The node `simulate`: forces of rubber components for the displacements on their topics.
#include <ros/ros.h>

#include "command.h"
#include "rubber_suspension/ros_interface/command_line.h"
#include "rubber_suspension/ros_interface/simulate_node.h"

using namespace rubber_suspension;

namespace {

int serve(RosCommandLine& line) {
  line.initialise("simulate");
  ros::NodeHandle private_handle("~");
  const SimulateNode node(ros::NodeHandle(), private_handle);
  ros::spin();
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  RosCommandLine line(argc, argv);
  return runCommand(
      line.argc(), line.argv(), "simulate",
      "Publishes <component>/force for every sample on <component>/displacement.\n\nPrivate parameters:\n" +
          describeNodeSettings(),
      [&](CLI::App&) { return [&] { return serve(line); }; });
}
