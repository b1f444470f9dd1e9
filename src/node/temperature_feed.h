// Temperatures with their own stamps, for the samples from those stamps on. Independent of ROS.
#pragma once

#include <boost/circular_buffer.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace rubber_suspension::node {

/// Each temperature applies from its stamp to that of the next; a late one, from the next sample on. For one thread.
/// Allocates once, with the first temperature.
class TemperatureFeed {
 public:
  static constexpr std::size_t kMostWaiting = 1024;  ///< ahead of their samples; beyond, the oldest is dropped

  /// A stamp [ns] before the newest one begins a new replay and discards the waiting temperatures.
  void add(std::int64_t stamp, double temperature) {
    if (waiting_.capacity() == 0) {
      waiting_.set_capacity(kMostWaiting);
    }
    if (!waiting_.empty() && stamp < waiting_.back().stamp) {
      waiting_.clear();
    }
    waiting_.push_back({stamp, temperature});
  }

  /// The temperature [degC] of a sample with this stamp [ns], if it is another than that of the sample before.
  std::optional<double> take(std::int64_t stamp) {
    bool changed = false;
    while (!waiting_.empty() && waiting_.front().stamp <= stamp) {
      changed = changed || current_ != waiting_.front().temperature;
      current_ = waiting_.front().temperature;
      waiting_.pop_front();
    }
    return changed ? current_ : std::nullopt;
  }

  /// Temperature of the last sample, if it had one.
  const std::optional<double>& current() const { return current_; }

 private:
  struct Entry {
    std::int64_t stamp;
    double temperature;
  };

  boost::circular_buffer<Entry> waiting_;
  std::optional<double> current_;
};

}  // namespace rubber_suspension::node
