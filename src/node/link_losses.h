// Which subscriber of a topic lost which messages, by who still holds them; knows no ROS.
#pragma once

#include <boost/shared_array.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace rubber_suspension::node {

/// Losses of the queues of one topic, each of which drops its oldest message for a new one once it is full.
///
/// A queue that is full holds the last `queue_size` messages in their order, so what a message pushes out is always the
/// one `queue_size` before it. Whoever held that one before the message was handed to it, and does not hold it after,
/// has lost it. Meanwhile nothing may be sent. Messages that all have been sent are let go at once: nothing is kept
/// that no queue keeps. From one thread.
class LinkLosses {
 public:
  using Buffer = boost::shared_array<std::uint8_t>;

  explicit LinkLosses(std::size_t queue_size) : queue_size_(queue_size) {}

  /// A message comes, and no queue has it yet.
  void begin(const Buffer& message);

  /// The message has been handed to further queues: how many of them lost one for it.
  std::size_t passed();

  /// Messages that may still wait in a queue.
  std::size_t waiting() const { return window_.size(); }

 private:
  std::size_t queue_size_;
  std::deque<Buffer> window_;
  bool full_ = false;  // the oldest of the window is pushed out by the message that is handed over
  long holders_ = 0;   // of that oldest, this object among them
};

}  // namespace rubber_suspension::node
