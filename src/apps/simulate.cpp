// The node `simulate`: forces of rubber components for the displacements on their topics.
#include <ros/ros.h>

#include <CLI/CLI.hpp>

#include "rubber_suspension/ros_interface/simulate_node.h"

int main(int argc, char** argv) {
  std::vector<std::string> arguments;
  ros::removeROSArgs(argc, argv, arguments);
  CLI::App app("Publish <component>/force for every sample on <component>/displacement.\nPrivate parameters:\n" +
               rubber_suspension::describeNodeSettings());
  app.set_version_flag("--version", RUBBER_SUSPENSION_VERSION);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend() - 1));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  ros::init(argc, argv, "simulate");
  ros::NodeHandle private_handle("~");
  try {
    const rubber_suspension::SimulateNode node(ros::NodeHandle(), private_handle);
    ros::spin();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
