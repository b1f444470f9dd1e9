// Notices samples that were sent but never arrived, by the sequence number that every sender counts up.
#pragma once

#include <array>
#include <cstdint>

namespace rubber_suspension::node {

/// Follows the sequence numbers of up to kSenders senders to one topic; forgets the one silent for longest.
class SequenceWatch {
 public:
  /// Take a number of a sender (any address that stands for its connection). Returns how many the sender skipped.
  std::uint32_t take(const void* sender, std::uint32_t sequence);

 private:
  static constexpr std::size_t kSenders = 8;
  struct Sender {
    const void* address = nullptr;
    std::uint32_t last = 0;
    std::uint64_t used = 0;
  };

  std::array<Sender, kSenders> senders_{};
  std::uint64_t clock_ = 0;
};

}  // namespace rubber_suspension::node
