// The service ~get_loggers of this process, answered by ourselves.
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>
#include <vector>

namespace rubber_suspension::roscpp_fixes {

/// roscpp's own ~get_loggers frees the repository of all loggers where rosconsole is built with log4cxx 1.0 (Debian
/// 12): the process then ends at its next line of log. What is returned takes its place as long as it exists: one for
/// the process, which all nodelets in it share.
std::shared_ptr<ros::ServiceServer> takeOverLoggerService();

/// Resolved names of the services about loggers, roscpp's own ~set_logger_level among them.
std::vector<std::string> loggerServices();

}  // namespace rubber_suspension::roscpp_fixes
