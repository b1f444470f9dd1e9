// Counts messages of a topic that a subscriber lost, by their reference counts. Independent of ROS.
#pragma once

#include <boost/shared_array.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace rubber_suspension::node {

/// A queue that is full holds the last `queue_size` messages in their order, so what a message pushes out is always the
/// one `queue_size` before it. Whoever held that one before the message was handed over, and does not hold it after,
/// has lost it. Meanwhile nothing may be sent. Nothing is kept that no queue keeps. For one thread.
class LossCount {
 public:
  using Buffer = boost::shared_array<std::uint8_t>;

  explicit LossCount(std::size_t queue_size) : queue_size_(queue_size) {}

  /// A message comes, and no queue has it yet.
  void begin(const Buffer& message) {
    // A message that is just being sent to a subscriber is in no queue any more, however old it is.
    while (window_.size() > queue_size_ || (!window_.empty() && window_.front().use_count() == 1)) {
      window_.pop_front();
    }
    holders_ = window_.size() == queue_size_ ? window_.front().use_count() : 0;
    window_.push_back(message);
  }

  /// The message has been handed to all queues: whether any lost another for it.
  bool end() {
    const long before = std::exchange(holders_, 0);
    return before > 0 && window_.front().use_count() < before;
  }

 private:
  std::size_t queue_size_;
  std::deque<Buffer> window_;
  long holders_ = 0;  // of the oldest, this object among them, where the message pushes it out
};

}  // namespace rubber_suspension::node
