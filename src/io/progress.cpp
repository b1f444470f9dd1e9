// A progress bar on a terminal.
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

}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), shown_(total > 0 && isatty(STDERR_FILENO) != 0) {
  advance(0);
}

Progress::~Progress() {
  if (shown_) {
    std::fputs("\r\x1b[K", stderr);
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
  if (percent == percent_.load()) {  // else another thread is further on
    std::fprintf(stderr, "\r%s\x1b[K", bar(label_, percent, terminalWidth() - 1).c_str());
    std::fflush(stderr);
  }
}

std::string Progress::bar(const std::string& label, int percent, std::size_t width) {
  constexpr std::size_t kLength = 40;
  const std::size_t filled = kLength * static_cast<std::size_t>(percent) / 100;
  return fmt::format("{} {:3d} % [{}{}]", label, percent, std::string(filled, '='), std::string(kLength - filled, ' '))
      .substr(0, width);
}

}  // namespace rubber_suspension::io
