// Detects lost messages of a topic from their reference counts. Independent of ROS.
#pragma once

#include <boost/shared_array.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace rubber_suspension::node {

/// Detects messages that subscribers lose. A full queue contains the last `queue_size` messages, so a new message
/// displaces the oldest one. If the reference count of the oldest message decreases while the new one is handed over to
/// the queues, a subscriber has lost the oldest message. So no message may be sent during the hand-over. Only messages
/// that are in a queue are stored. Not thread-safe.
class LossCount {
 public:
  using Buffer = boost::shared_array<std::uint8_t>;

  explicit LossCount(std::size_t queue_size) : queue_size_(queue_size) {}

  /// Begins the hand-over of a message. Call this before any queue contains the message.
  void begin(const Buffer& message) {
    // Removes messages that are in no queue: newer ones have displaced them, or nothing else refers to them.
    while (window_.size() > queue_size_ || (!window_.empty() && window_.front().use_count() == 1)) {
      window_.pop_front();
    }
    holders_ = window_.size() == queue_size_ ? window_.front().use_count() : 0;
    window_.push_back(message);
  }

  /// Ends the hand-over, when all queues contain the message. Returns true if a queue has lost the oldest message.
  bool end() {
    const long before = std::exchange(holders_, 0);
    return before > 0 && window_.front().use_count() < before;
  }

 private:
  std::size_t queue_size_;
  std::deque<Buffer> window_;
  long holders_ = 0;  // reference count of the oldest message in a full queue; 0 if there is none
};

}  // namespace rubber_suspension::node
