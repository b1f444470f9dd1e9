// The orderly end of a node.
#include "ros_interface/termination.h"

#include <pthread.h>
#include <ros/init.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

namespace rubber_suspension::ros_interface {
namespace {

constexpr std::chrono::seconds kLimit(5);

std::atomic<bool> signal_came{false};

sigset_t endingSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    sigaddset(&signals, number);
  }
  return signals;
}

[[noreturn]] void endNow() {
  // Nothing else may be locked here: the process may hang anywhere.
  constexpr char kLine[] = "ended without leaving the master: it took longer than 5 s\n";
  (void)!write(STDERR_FILENO, kLine, sizeof(kLine) - 1);
  _exit(1);
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
  pthread_setname_np(pthread_self(), "termination");
  const sigset_t signals = endingSignals();
  const timespec turn{0, 20000000};
  while (sigtimedwait(&signals, nullptr, &turn) < 0 && !ros::isShuttingDown()) {
    if (finished_) {
      return;
    }
  }
  signal_came = true;
  const auto end = std::chrono::steady_clock::now() + kLimit;
  while (!finished_) {
    if (std::chrono::steady_clock::now() > end) {
      endNow();
    }
    sigtimedwait(&signals, nullptr, &turn);
  }
}

}  // namespace rubber_suspension::ros_interface
