// The service ~get_loggers of this process.
#include "roscpp_fixes/logger_service.h"

#include <ros/console.h>
#include <ros/console_impl.h>
#include <ros/names.h>
#include <ros/service_manager.h>
#include <ros/this_node.h>
#include <roscpp/GetLoggers.h>

#include <mutex>
#include <utility>

namespace rubber_suspension::roscpp_fixes {
namespace {

// The lowest level that a logger lets through, by the name that ~set_logger_level takes.
std::string levelOf(const std::string& logger) {
  using ros::console::levels::Level;
  static constexpr std::pair<Level, const char*> kLevels[] = {
      {Level::Debug, "debug"}, {Level::Info, "info"}, {Level::Warn, "warn"}, {Level::Error, "error"}};
  void* const handle = ros::console::impl::getHandle(logger);
  for (const auto& [level, name] : kLevels) {
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

std::shared_ptr<ros::ServiceServer> takeOverLoggerService() {
  static std::mutex mutex;
  static std::weak_ptr<ros::ServiceServer> existing;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<ros::ServiceServer> result = existing.lock();
  if (!result) {
    const std::string name = loggerServices().front();
    ros::ServiceManager::instance()->unadvertiseService(name);
    existing = result = std::make_shared<ros::ServiceServer>(ros::NodeHandle().advertiseService(name, answer));
  }
  return result;
}

std::vector<std::string> loggerServices() {
  const std::string& node = ros::this_node::getName();
  return {ros::names::append(node, "get_loggers"), ros::names::append(node, "set_logger_level")};
}

}  // namespace rubber_suspension::roscpp_fixes
