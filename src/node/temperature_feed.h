// Temperatures with their own stamps, which apply to the samples from these stamps on. Independent of ROS.
#pragma once

#include <boost/circular_buffer.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace rubber_suspension::node {

/// Determines the temperature of each sample. A temperature applies from its stamp to the stamp of the next
/// temperature. A temperature that comes late applies from the next sample on. Not thread-safe. Allocates once, with
/// the first temperature.
class TemperatureFeed {
 public:
  static constexpr std::size_t kMostWaiting = 1024;  ///< temperatures that may wait before the oldest is dropped

  /// Adds a temperature [degC]. A stamp [ns] before the newest begins a new replay and discards waiting temperatures.
  void add(std::int64_t stamp, double temperature) {
    if (waiting_.capacity() == 0) {
      waiting_.set_capacity(kMostWaiting);
    }
    if (!waiting_.empty() && stamp < waiting_.back().stamp) {
      waiting_.clear();
    }
    waiting_.push_back({stamp, temperature});
  }

  /// Returns the temperature [degC] at the stamp of a sample [ns] if it has changed since the last sample.
  std::optional<double> take(std::int64_t stamp) {
    bool changed = false;
    while (!waiting_.empty() && waiting_.front().stamp <= stamp) {
      changed = changed || current_ != waiting_.front().temperature;
      current_ = waiting_.front().temperature;
      waiting_.pop_front();
    }
    return changed ? current_ : std::nullopt;
  }

  /// Returns the temperature [degC] at the last sample, if there was one.
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
