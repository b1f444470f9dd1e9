// Keeps a node on the loopback interface.
#include "ros_interface/loopback.h"

#include <fmt/format.h>
#include <net/if.h>
#include <netinet/in.h>
#include <ros/network.h>
#include <ros/xmlrpc_manager.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <vector>

namespace rubber_suspension::ros_interface {
namespace {

constexpr std::array<char, 3> kLoopback = {'l', 'o', '\0'};

bool listensOn(int file, std::uint32_t port) {
  int listens = 0;
  socklen_t size = sizeof(listens);
  if (getsockopt(file, SOL_SOCKET, SO_ACCEPTCONN, &listens, &size) != 0 || listens == 0) {
    return false;
  }
  sockaddr_storage address{};
  size = sizeof(address);
  if (getsockname(file, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    return false;
  }
  // The port lies at the same place for IPv4 and IPv6.
  return (address.ss_family == AF_INET || address.ss_family == AF_INET6) &&
         ntohs(reinterpret_cast<const sockaddr_in*>(&address)->sin_port) == port;
}

// roscpp does not hand out its sockets, so they are looked for among all files of this process.
std::vector<int> listenersOf(std::uint32_t port) {
  std::vector<int> listeners;
  std::error_code gone;  // a file may be closed while the folder is read
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", gone)) {
    const int file = std::atoi(entry.path().filename().c_str());
    if (listensOn(file, port)) {
      listeners.push_back(file);
    }
  }
  return listeners;
}

}  // namespace

bool isKeptToLoopback() {
  const std::string& host = ros::network::getHost();
  return host == "localhost" || host == "::1" || host.compare(0, 4, "127.") == 0;
}

std::string keepSlaveApiToLoopback() {
  if (!isKeptToLoopback()) {
    return {};
  }
  const std::vector<int> listeners = listenersOf(ros::XMLRPCManager::instance()->getServerPort());
  for (const int listener : listeners) {
    if (setsockopt(listener, SOL_SOCKET, SO_BINDTODEVICE, kLoopback.data(), kLoopback.size()) != 0) {
      return fmt::format("the slave API listens on all interfaces: {}", std::strerror(errno));
    }
  }
  return listeners.empty() ? "the slave API listens on all interfaces: its socket was not found" : std::string();
}

std::string interfaceOf(std::uint32_t port) {
  std::array<char, IFNAMSIZ> name{};
  for (const int listener : listenersOf(port)) {
    socklen_t size = name.size();
    if (getsockopt(listener, SOL_SOCKET, SO_BINDTODEVICE, name.data(), &size) == 0) {
      return name.data();
    }
  }
  return {};
}

}  // namespace rubber_suspension::ros_interface
