// Remedies for faults of roscpp that concern the whole process: its service ~get_loggers and its open slave API.
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// Returns a service that replaces roscpp's ~get_loggers while it exists, shared by all nodelets of the process. With
/// rosconsole built with log4cxx 1.0 (Debian 12), roscpp's own frees the repository of all loggers, and the process
/// ends at its next line of log.
std::shared_ptr<ros::ServiceServer> takeOverLoggerService();

/// Returns the resolved names of the services for loggers, including roscpp's own ~set_logger_level.
std::vector<std::string> loggerServices();

/// Binds the slave API to the loopback interface if ROS_IP or ROS_HOSTNAME restricts this process to it: roscpp
/// restricts only the samples, and listens for calls of the slave API on all interfaces. Call this once ROS runs.
/// Returns why it failed, or an empty text. Linux before 5.7 permits it to root only.
std::string keepSlaveApiToLoopback();

}  // namespace rubber_suspension::ros_interface
