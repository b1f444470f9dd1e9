// The orderly end of a node.
#include "ros_interface/termination.h"

#include <pthread.h>
#include <ros/init.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>

#include "ros_interface/timed_call.h"

namespace rubber_suspension::ros_interface {
namespace {

constexpr double kMasterLimit = 0.5;               // [s]
constexpr std::chrono::seconds kShutdownLimit(5);  // hundreds of topics leave the master one by one

sigset_t endingSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    sigaddset(&signals, number);
  }
  return signals;
}

[[noreturn]] void endNow(const char* reason) {
  // Nothing else may be locked here: the process may hang anywhere.
  std::string line = std::string("ended without leaving the master: ") + reason + "\n";
  (void)!write(STDERR_FILENO, line.data(), line.size());
  _exit(0);
}

}  // namespace

Termination::Termination() {
  const sigset_t signals = endingSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  thread_ = std::thread([this] { wait(); });
}

Termination::~Termination() {
  finished_ = true;
  thread_.join();
}

void Termination::wait() {
  pthread_setname_np(pthread_self(), "termination");
  const sigset_t signals = endingSignals();
  const timespec turn{0, 20000000};
  while (sigtimedwait(&signals, nullptr, &turn) < 0) {
    if (finished_) {
      return;
    }
  }
  const auto end = std::chrono::steady_clock::now() + kShutdownLimit;
  if (!ros::isInitialized() || !masterAnswers(kMasterLimit)) {
    endNow("it does not answer");
  }
  ros::requestShutdown();
  while (!finished_) {
    if (std::chrono::steady_clock::now() > end) {
      endNow("it took too long");
    }
    sigtimedwait(&signals, nullptr, &turn);
  }
}

}  // namespace rubber_suspension::ros_interface
