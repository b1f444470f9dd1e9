// Orderly end of a node.
#include "ros_interface/termination.h"

#include <pthread.h>
#include <ros/init.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

namespace rubber_suspension::ros_interface {
namespace {

std::atomic<bool> signal_came{false};

sigset_t endingSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    sigaddset(&signals, number);
  }
  return signals;
}

}  // namespace

bool isEnding() { return signal_came || ros::isShuttingDown(); }

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
  using Clock = std::chrono::steady_clock;
  pthread_setname_np(pthread_self(), "termination");
  const sigset_t signals = endingSignals();
  const timespec turn{0, 20000000};
  auto end = Clock::time_point::max();
  while (!finished_) {
    const bool came = sigtimedwait(&signals, nullptr, &turn) > 0 || ros::isShuttingDown();
    if (came && !signal_came.exchange(true)) {
      end = Clock::now() + std::chrono::seconds(5);
    }
    if (Clock::now() > end) {  // nothing here may lock, because the process may hang anywhere
      constexpr char kLine[] = "ended without unregistering from the master, because this took longer than 5 s\n";
      (void)!write(STDERR_FILENO, kLine, sizeof(kLine) - 1);
      _exit(1);
    }
  }
}

}  // namespace rubber_suspension::ros_interface
