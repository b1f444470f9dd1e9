// The service ~get_loggers of this process, answered by ourselves.
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// roscpp's own ~get_loggers frees the repository of all loggers where rosconsole is built with log4cxx 1.0 (Debian
/// 12): the process then ends at its next line of log. This takes its place as long as it exists.
class LoggerService {
 public:
  /// One for the process, which all nodelets in it share.
  static std::shared_ptr<LoggerService> get();

  LoggerService();
  LoggerService(const LoggerService&) = delete;
  LoggerService& operator=(const LoggerService&) = delete;

  /// Resolved names of the services about loggers, roscpp's own ~set_logger_level among them.
  static std::vector<std::string> names();

 private:
  ros::NodeHandle handle_;
  ros::ServiceServer server_;
};

}  // namespace rubber_suspension::ros_interface
