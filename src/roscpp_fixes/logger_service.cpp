// The service ~get_loggers of this process.
#include "ros_interface/logger_service.h"

#include <ros/console.h>
#include <ros/console_impl.h>
#include <ros/names.h>
#include <ros/service_manager.h>
#include <ros/this_node.h>
#include <roscpp/GetLoggers.h>

#include <array>
#include <mutex>
#include <string>
#include <utility>

namespace rubber_suspension::ros_interface {
namespace {

// The lowest level that a logger lets through, by the name that ~set_logger_level takes.
std::string levelOf(const std::string& logger) {
  using ros::console::levels::Level;
  static const std::array<std::pair<Level, const char*>, 5> levels = {{{Level::Debug, "debug"},
                                                                       {Level::Info, "info"},
                                                                       {Level::Warn, "warn"},
                                                                       {Level::Error, "error"},
                                                                       {Level::Fatal, "fatal"}}};
  void* const handle = ros::console::impl::getHandle(logger);
  for (const auto& [level, name] : levels) {
    if (ros::console::impl::isEnabledFor(handle, level)) {
      return name;
    }
  }
  return "fatal";
}

bool answer(roscpp::GetLoggers::Request& /*request*/, roscpp::GetLoggers::Response& response) {
  for (const char* name :
       {ROSCONSOLE_ROOT_LOGGER_NAME, "ros.diagnostic_updater", "ros.nodelet", "ros.roscpp", ROSCONSOLE_DEFAULT_NAME}) {
    response.loggers.emplace_back();
    response.loggers.back().name = name;
    response.loggers.back().level = levelOf(name);
  }
  return true;
}

}  // namespace

std::shared_ptr<LoggerService> LoggerService::get() {
  static std::mutex mutex;
  static std::weak_ptr<LoggerService> existing;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<LoggerService> result = existing.lock();
  if (!result) {
    existing = result = std::make_shared<LoggerService>();
  }
  return result;
}

std::vector<std::string> LoggerService::names() {
  const std::string& node = ros::this_node::getName();
  return {ros::names::append(node, "get_loggers"), ros::names::append(node, "set_logger_level")};
}

LoggerService::LoggerService() {
  const std::string name = names().front();
  ros::ServiceManager::instance()->unadvertiseService(name);
  server_ = handle_.advertiseService(name, answer);
}

}  // namespace rubber_suspension::ros_interface
