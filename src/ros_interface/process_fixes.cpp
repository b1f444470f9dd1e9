// Remedies for faults of roscpp that concern the whole process.
#include "ros_interface/process_fixes.h"

#include <netinet/in.h>
#include <ros/console.h>
#include <ros/console_impl.h>
#include <ros/network.h>
#include <ros/service_manager.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <roscpp/GetLoggers.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>

namespace rubber_suspension::ros_interface {
namespace {

// Returns the lowest level that a logger writes, under its name for ~set_logger_level.
std::string levelOf(const std::string& logger) {
  const std::vector<std::string> levels = {"debug", "info", "warn", "error"};  // as rosconsole numbers them
  std::size_t level = 0;
  while (level < levels.size() && !ros::console::impl::isEnabledFor(ros::console::impl::getHandle(logger),
                                                                    static_cast<ros::console::Level>(level))) {
    ++level;
  }
  return level < levels.size() ? levels[level] : "fatal";
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

bool hasPort(int file, std::uint32_t port) {
  sockaddr_in6 address{};  // an IPv4 address stores its port at the same offset
  socklen_t size = sizeof(address);
  return getsockname(file, reinterpret_cast<sockaddr*>(&address), &size) == 0 &&
         (address.sin6_family == AF_INET || address.sin6_family == AF_INET6) && ntohs(address.sin6_port) == port;
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
  return {ros::this_node::getName() + "/get_loggers", ros::this_node::getName() + "/set_logger_level"};
}

// Searches for the socket among all open files of this process, because roscpp does not expose it.
std::string keepSlaveApiToLoopback() {
  const std::string& host = ros::network::getHost();
  if (host != "localhost" && host != "::1" && host.compare(0, 4, "127.") != 0) {
    return {};
  }
  constexpr char kLoopback[] = "lo";
  std::string refusal = "the socket was not found";
  std::error_code gone;  // a file may be closed while the folder is read
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", gone)) {
    const int file = std::atoi(entry.path().filename().c_str());
    if (hasPort(file, ros::XMLRPCManager::instance()->getServerPort())) {
      const bool kept = setsockopt(file, SOL_SOCKET, SO_BINDTODEVICE, kLoopback, sizeof(kLoopback)) == 0;
      refusal = kept ? "" : std::strerror(errno);
    }
  }
  return refusal.empty() ? refusal : "the slave API listens on all interfaces: " + refusal;
}

}  // namespace rubber_suspension::ros_interface
