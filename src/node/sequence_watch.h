// Notices samples that were sent but never arrived, by the sequence number that every sender counts up. Knows no ROS.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

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
    Entry* place = &entries_[0];
    for (Entry& known : entries_) {
      if (known.sender == sender && known.used != 0) {
        const std::uint32_t skipped = sequence - known.last - 1;
        known.last = sequence;
        known.used = clock_;
        // A number that goes back is a sender that counts again from the start or in its own way: nothing is known to
        // be lost.
        return skipped < (1U << 31) ? skipped : 0;
      }
      if (known.used < place->used) {
        place = &known;
      }
    }
    *place = {sender, sequence, clock_};
    return 0;
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
