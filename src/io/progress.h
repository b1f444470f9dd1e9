// Progress of long work on a terminal.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace rubber_suspension::io {

/// Shows on stderr how much of a task is done. Does nothing if stderr is not a terminal.
/// advance() may be called for every item and from several threads, because it draws only when the percentage changes.
class Progress {
 public:
  Progress(std::string label, std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  ///< removes the bar, so that the next output begins on a clean line

  void advance(std::size_t n = 1);

  /// Returns the bar as text, "label  50 % [=====     ]", cut to `width` characters.
  static std::string bar(const std::string& label, int percent, std::size_t width);

 private:
  void draw(int percent);

  std::string label_;
  std::size_t total_;
  bool shown_;
  std::atomic<std::size_t> done_{0};
  std::atomic<int> percent_{-1};
  std::mutex mutex_;
};

/// Shows, for work of unknown length, what is being done and for how long. It appears on stderr after one second, if
/// stderr is a terminal. Only one object may exist at a time, and no Progress at the same time.
class Activity {
 public:
  explicit Activity(std::string label);
  Activity(const Activity&) = delete;
  Activity& operator=(const Activity&) = delete;
  ~Activity();  ///< removes the line

 private:
  void run();

  const std::string label_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable ended_;
  bool is_ended_ = false;
  std::thread thread_;
};

}  // namespace rubber_suspension::io
