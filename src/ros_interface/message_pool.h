// Messages that are allocated once and reused, so that publishing allocates no message.
#pragma once

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>
#include <cstddef>
#include <vector>

namespace rubber_suspension::ros_interface {

/// Provides messages to which no one else has a pointer. A subscriber in the same process (nodelet) receives the
/// message itself and may keep it. The pool reuses a message only when it has been released. Not thread-safe.
template <class Message>
class MessagePool {
 public:
  using Pointer = boost::shared_ptr<Message>;

  /// Returns a message that may be written. If kTries stored messages are in use, it is a new one. At most kMaximum
  /// messages are stored.
  Pointer take() {
    for (std::size_t tried = 0; tried < kTries && tried < messages_.size(); ++tried) {
      next_ = next_ + 1 < messages_.size() ? next_ + 1 : 0;
      if (messages_[next_].use_count() == 1) {
        return messages_[next_];
      }
    }
    Pointer fresh = boost::make_shared<Message>();
    if (messages_.size() < kMaximum) {
      messages_.push_back(fresh);
    }
    return fresh;
  }

  std::size_t size() const { return messages_.size(); }

 private:
  static constexpr std::size_t kTries = 16;  // bounds the time of a call
  static constexpr std::size_t kMaximum = 1024;

  std::vector<Pointer> messages_;
  std::size_t next_ = 0;
};

}  // namespace rubber_suspension::ros_interface
