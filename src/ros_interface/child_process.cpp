// Child processes.
#include "ros_interface/child_process.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "element/refuse.h"

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
  constexpr int kTurns = 500;  // each of 10 ms
  for (int turn = 0; running(); ++turn) {
    if (turn == 0 || turn == kTurns) {
      kill(id_, turn == 0 ? SIGINT : SIGKILL);
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
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

int freePort() {
  using boost::asio::ip::tcp;
  boost::asio::io_context context;
  const tcp::acceptor acceptor(context, tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0));
  return acceptor.local_endpoint().port();
}

}  // namespace rubber_suspension::ros_interface
