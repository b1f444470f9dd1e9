// Detects messages of a topic that a subscriber lost, by their reference counts. Independent of ROS.
#pragma once

#include <boost/shared_array.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace rubber_suspension::node {

/// A full queue contains the last `queue_size` messages, so a new message displaces the one `queue_size` before it. If
/// the reference count of the latter drops while the new message is handed over, a subscriber has lost it; so nothing
/// may be sent meanwhile. Only messages that are in a queue are stored. Not thread-safe.
class LossCount {
 public:
  using Buffer = boost::shared_array<std::uint8_t>;

  explicit LossCount(std::size_t queue_size) : queue_size_(queue_size) {}

  /// Begins the hand-over of a message; call this before any queue has it.
  void begin(const Buffer& message) {
    // A message that is being sent to a subscriber is no longer in a queue, however old it is.
    while (window_.size() > queue_size_ || (!window_.empty() && window_.front().use_count() == 1)) {
      window_.pop_front();
    }
    holders_ = window_.size() == queue_size_ ? window_.front().use_count() : 0;
    window_.push_back(message);
  }

  /// Ends the hand-over; call this when all queues have the message. Returns true if a queue lost another one.
  bool end() {
    const long before = std::exchange(holders_, 0);
    return before > 0 && window_.front().use_count() < before;
  }

 private:
  std::size_t queue_size_;
  std::deque<Buffer> window_;
  long holders_ = 0;  // reference count of the message to be displaced; 0: there is none
};

}  // namespace rubber_suspension::node
