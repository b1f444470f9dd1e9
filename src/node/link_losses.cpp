// Which subscriber of a topic lost which messages.
#include "node/link_losses.h"

#include <algorithm>

namespace rubber_suspension::node {

void LinkLosses::begin(const Buffer& message) {
  // What is just being sent to a subscriber is in no queue any more, however old it is.
  while (window_.size() > queue_size_) {
    window_.pop_front();
  }
  while (!window_.empty() && window_.front().use_count() == 1) {
    window_.pop_front();
  }
  full_ = window_.size() == queue_size_;
  holders_ = full_ ? window_.front().use_count() : 0;
  window_.push_back(message);
}

std::size_t LinkLosses::passed() {
  if (!full_) {
    return 0;
  }
  const long holders = window_.front().use_count();
  const long lost = std::max(0L, holders_ - holders);
  holders_ = holders;
  return static_cast<std::size_t>(lost);
}

}  // namespace rubber_suspension::node
