// Remedies for faults of roscpp that concern the whole process: its service ~get_loggers and its open slave API.
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// Returns a service that replaces roscpp's ~get_loggers while the service exists. All nodelets of the process share
/// it. If rosconsole is built with log4cxx 1.0 (Debian 12), roscpp's own service frees the repository of all loggers,
/// and the process crashes at its next line of log.
std::shared_ptr<ros::ServiceServer> takeOverLoggerService();

/// Returns the resolved names of the services for loggers, including roscpp's own ~set_logger_level.
std::vector<std::string> loggerServices();

/// Binds the slave API to the loopback interface if ROS_IP or ROS_HOSTNAME restricts this process to that interface.
/// roscpp restricts only the connections for samples and listens for calls of the slave API on all interfaces. Call
/// this after ROS has started. Returns the reason of a failure, or an empty text. Linux before 5.7 permits this to root
/// only.
std::string keepSlaveApiToLoopback();

}  // namespace rubber_suspension::ros_interface
