// Progress of long work on a terminal.
#include "io/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace rubber_suspension::io {
namespace {

std::size_t terminalWidth() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

void showLine(const std::string& text) {
  std::fprintf(stderr, "\r%s\x1b[K", text.c_str());
  std::fflush(stderr);
}

}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), shown_(total > 0 && isatty(STDERR_FILENO) != 0) {
  advance(0);
}

Progress::~Progress() {
  if (shown_) {
    showLine("");
  }
}

void Progress::advance(std::size_t n) {
  if (!shown_) {
    return;
  }
  const std::size_t done = std::min(done_.fetch_add(n) + n, total_);
  const int percent = static_cast<int>(100.0 * static_cast<double>(done) / static_cast<double>(total_));
  int previous = percent_.load();
  while (percent > previous) {
    if (percent_.compare_exchange_weak(previous, percent)) {
      draw(percent);
      return;
    }
  }
}

void Progress::draw(int percent) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (percent == percent_.load()) {  // if not, another thread has advanced further and draws
    showLine(bar(label_, percent, terminalWidth() - 1));
  }
}

std::string Progress::bar(const std::string& label, int percent, std::size_t width) {
  constexpr std::size_t kLength = 40;
  const std::size_t filled = kLength * static_cast<std::size_t>(percent) / 100;
  return fmt::format("{} {:3d} % [{}{}]", label, percent, std::string(filled, '='), std::string(kLength - filled, ' '))
      .substr(0, width);
}

Activity::Activity(std::string label) : label_(std::move(label)) {
  if (isatty(STDERR_FILENO) != 0) {
    thread_ = std::thread([this] { run(); });
  }
}

Activity::~Activity() {
  if (thread_.joinable()) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_ended_ = true;
    }
    ended_.notify_one();
    thread_.join();
  }
}

void Activity::run() {
  constexpr std::chrono::seconds kStep{1};
  bool shown = false;
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ended_.wait_for(lock, kStep, [this] { return is_ended_; })) {
    const auto since = std::chrono::steady_clock::now() - start_;
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(since).count();
    showLine(fmt::format("{}, {} s", label_, seconds).substr(0, terminalWidth() - 1));
    shown = true;
  }
  if (shown) {
    showLine("");
  }
}

}  // namespace rubber_suspension::io
