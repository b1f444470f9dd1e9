// Programs that a benchmark starts and ends.
#include "ros_interface/child_process.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace rubber_suspension::ros_interface {

ChildProcess::ChildProcess(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));  // posix_spawn does not write to them
  }
  arguments.push_back(nullptr);
  const int error = posix_spawnp(&id_, arguments[0], nullptr, nullptr, arguments.data(), environ);
  if (error != 0) {
    throw std::runtime_error(fmt::format("{} cannot be started: {}", command[0], std::strerror(error)));
  }
}

ChildProcess::~ChildProcess() {
  if (!running()) {
    return;
  }
  kill(id_, SIGINT);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (running()) {
    if (std::chrono::steady_clock::now() > end) {
      kill(id_, SIGKILL);
      waitpid(id_, nullptr, 0);
      id_ = -1;
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

bool ChildProcess::running() {
  if (id_ > 0 && waitpid(id_, nullptr, WNOHANG) == id_) {
    id_ = -1;
  }
  return id_ > 0;
}

std::string siblingProgram(const std::string& name) {
  std::array<char, 4096> path{};
  const ssize_t length = readlink("/proc/self/exe", path.data(), path.size() - 1);
  const std::string self(path.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
  return self.substr(0, self.find_last_of('/') + 1) + name;
}

int freePort() {
  const int socket_handle = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  const bool bound = socket_handle >= 0 && bind(socket_handle, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                     getsockname(socket_handle, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  if (socket_handle >= 0) {
    close(socket_handle);
  }
  if (!bound) {
    throw std::runtime_error(fmt::format("no free port: {}", std::strerror(errno)));
  }
  return ntohs(address.sin_port);
}

}  // namespace rubber_suspension::ros_interface
