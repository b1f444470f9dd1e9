// A thread that serves a group of components.
#include "ros_interface/serving_thread.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>

namespace rubber_suspension::ros_interface {
std::string ServingThread::start(const std::string& name, int realtime_priority) {
  name_ = name;
  running_ = true;
  last_round_ = Clock::now();
  thread_ = std::thread([this] { run(); });
  pthread_setname_np(thread_.native_handle(), name.c_str());
  if (realtime_priority <= 0) {
    return {};
  }
  sched_param parameters{};
  parameters.sched_priority = realtime_priority;
  const int error = pthread_setschedparam(thread_.native_handle(), SCHED_FIFO, &parameters);
  return error == 0 ? std::string()
                    : fmt::format("real-time priority {} cannot be set: {}; the node serves at normal priority",
                                  realtime_priority, std::strerror(error));
}

void ServingThread::stop() {
  if (!thread_.joinable()) {
    return;
  }
  running_ = false;
  queue_.disable();
  thread_.join();
  queue_.clear();
}

void ServingThread::run() {
  // Bounds the time until the thread notices that it has to end.
  const ros::WallDuration wait(0.1);
  while (running_) {
    queue_.callAvailable(wait);
    last_round_ = Clock::now();
  }
}

double ServingThread::silence() const {
  return std::chrono::duration<double>(Clock::now() - last_round_.load()).count();
}

std::string lockMemory() {
  const bool locked = mlockall(MCL_CURRENT) == 0 && mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
  return locked ? std::string() : fmt::format("the memory cannot be locked: {}", std::strerror(errno));
}

}  // namespace rubber_suspension::ros_interface
