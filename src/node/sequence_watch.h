// Notices samples that were sent but never arrived, by the sequence number that every sender counts up. Knows no ROS.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace rubber_suspension::node {

/// Follows the sequence numbers of up to kSenders senders to one topic; forgets the one silent for longest.
/// `Sender` is a shared pointer to anything that stands for a connection: held here, so that no later connection can
/// come to lie at the address of one that has ended and be taken for it.
template <class Sender>
class SequenceWatch {
 public:
  /// Take a number of a sender. Returns how many the sender skipped.
  std::uint32_t take(const Sender& sender, std::uint32_t sequence) {
    ++clock_;
    const auto known = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry& entry) { return entry.used != 0 && entry.sender == sender; });
    if (known == entries_.end()) {
      *std::min_element(entries_.begin(), entries_.end(),
                        [](const Entry& a, const Entry& b) { return a.used < b.used; }) = {sender, sequence, clock_};
      return 0;
    }
    known->used = clock_;
    const std::uint32_t skipped = sequence - std::exchange(known->last, sequence) - 1;
    // One that goes back is a sender that counts again from the start or in its own way: nothing is known to be lost.
    return skipped < (1U << 31) ? skipped : 0;
  }

 private:
  static constexpr std::size_t kSenders = 8;
  struct Entry {
    Sender sender{};
    std::uint32_t last = 0;
    std::uint64_t used = 0;  // 0: never
  };

  std::array<Entry, kSenders> entries_{};
  std::uint64_t clock_ = 0;
};

}  // namespace rubber_suspension::node
