// Keeps a node on the loopback interface.
#include "roscpp_fixes/loopback.h"

#include <fmt/format.h>
#include <netinet/in.h>
#include <ros/network.h>
#include <ros/xmlrpc_manager.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace rubber_suspension::roscpp_fixes {
namespace {

bool isKeptToLoopback() {
  const std::string& host = ros::network::getHost();
  return host == "localhost" || host == "::1" || host.compare(0, 4, "127.") == 0;
}

bool listensOn(int file, std::uint32_t port) {
  int listens = 0;
  socklen_t size = sizeof(listens);
  sockaddr_storage address{};
  socklen_t address_size = sizeof(address);
  // The port lies at the same place for IPv4 and IPv6.
  return getsockopt(file, SOL_SOCKET, SO_ACCEPTCONN, &listens, &size) == 0 && listens != 0 &&
         getsockname(file, reinterpret_cast<sockaddr*>(&address), &address_size) == 0 &&
         (address.ss_family == AF_INET || address.ss_family == AF_INET6) &&
         ntohs(reinterpret_cast<const sockaddr_in*>(&address)->sin_port) == port;
}

}  // namespace

// roscpp does not hand out its sockets, so they are looked for among all files of this process.
std::string keepSlaveApiToLoopback() {
  if (!isKeptToLoopback()) {
    return {};
  }
  constexpr char kLoopback[] = "lo";
  bool found = false;
  std::error_code gone;  // a file may be closed while the folder is read
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", gone)) {
    const int file = std::atoi(entry.path().filename().c_str());
    if (!listensOn(file, ros::XMLRPCManager::instance()->getServerPort())) {
      continue;
    }
    found = true;
    if (setsockopt(file, SOL_SOCKET, SO_BINDTODEVICE, kLoopback, sizeof(kLoopback)) != 0) {
      return fmt::format("the slave API listens on all interfaces: {}", std::strerror(errno));
    }
  }
  return found ? std::string() : "the slave API listens on all interfaces: its socket was not found";
}

}  // namespace rubber_suspension::roscpp_fixes
