// The node `simulate`: forces of rubber components for the displacements on their topics.
#include <ros/ros.h>

#include "apps/command.h"
#include "ros_interface/command_line.h"
#include "ros_interface/simulate_node.h"

using namespace rubber_suspension;
using namespace rubber_suspension::apps;

namespace {

int serve(ros_interface::RosCommandLine& line) {
  line.initialise("simulate");
  ros::NodeHandle private_handle("~");
  const ros_interface::SimulateNode node(ros::NodeHandle(), private_handle);
  ros::spin();
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  ros_interface::RosCommandLine line(argc, argv);
  return runCommand(
      line.argc(), line.argv(), "simulate",
      "Publishes <component>/force for every sample on <component>/displacement.\n\nPrivate parameters:\n" +
          ros_interface::describeNodeSettings(),
      [&](CLI::App&) { return [&] { return serve(line); }; });
}
