// Command lines of programs that are ROS nodes.
#include "ros_interface/command_line.h"

#include <ros/exception.h>
#include <ros/init.h>

#include <stdexcept>

namespace rubber_suspension::ros_interface {
namespace {

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size());
  for (std::string& text : texts) {
    pointers.push_back(text.data());
  }
  return pointers;
}

}  // namespace

RosCommandLine::RosCommandLine(int argc, char** argv) : all_(argv, argv + argc) {
  ros::removeROSArgs(argc, argv, own_);
  pointers_ = pointersTo(own_);
}

void RosCommandLine::initialise(const std::string& node_name, std::uint32_t options) {
  std::vector<char*> pointers = pointersTo(all_);
  int count = static_cast<int>(pointers.size());
  try {
    ros::init(count, pointers.data(), node_name, options);
  } catch (const ros::Exception& error) {
    throw std::runtime_error(error.what());
  }
}

}  // namespace rubber_suspension::ros_interface
