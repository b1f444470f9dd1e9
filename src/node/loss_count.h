// Counts messages of a topic that a subscriber lost, by their reference counts. Independent of ROS.
#pragma once

#include <boost/shared_array.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace rubber_suspension::node {

/// A full queue has the last `queue_size` messages in order, so a message displaces the one `queue_size` before it. An
/// owner of that one before, but not after the message was handed over, has lost it. Nothing may be sent meanwhile.
/// Only messages that are in a queue are kept. For one thread.
class LossCount {
 public:
  using Buffer = boost::shared_array<std::uint8_t>;

  explicit LossCount(std::size_t queue_size) : queue_size_(queue_size) {}

  /// To be called for a message before any queue has it.
  void begin(const Buffer& message) {
    // A message that is being sent to a subscriber is no longer in a queue, however old it is.
    while (window_.size() > queue_size_ || (!window_.empty() && window_.front().use_count() == 1)) {
      window_.pop_front();
    }
    holders_ = window_.size() == queue_size_ ? window_.front().use_count() : 0;
    window_.push_back(message);
  }

  /// To be called when all queues have the message; true if any lost another one for it.
  bool end() {
    const long before = std::exchange(holders_, 0);
    return before > 0 && window_.front().use_count() < before;
  }

 private:
  std::size_t queue_size_;
  std::deque<Buffer> window_;
  long holders_ = 0;  // of the oldest, including this object, if the message displaces it
};

}  // namespace rubber_suspension::node
