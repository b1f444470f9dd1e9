// Faults of roscpp that concern a process as a whole: its service ~get_loggers, and a slave API that all may call.
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// roscpp's own ~get_loggers frees the repository of all loggers where rosconsole is built with log4cxx 1.0 (Debian
/// 12): the process then ends at its next line of log. What is returned takes its place as long as it exists: one for
/// the process, which all nodelets in it share.
std::shared_ptr<ros::ServiceServer> takeOverLoggerService();

/// Resolved names of the services about loggers, roscpp's own ~set_logger_level among them.
std::vector<std::string> loggerServices();

/// Where ROS_IP or ROS_HOSTNAME keeps this process to the loopback interface, roscpp listens for samples there only,
/// but for the calls of its slave API on all interfaces: bind these to it as well. Call once ROS runs. Returns why that
/// was not possible, or nothing. Linux before 5.7 permits it to root only.
std::string keepSlaveApiToLoopback();

}  // namespace rubber_suspension::ros_interface
