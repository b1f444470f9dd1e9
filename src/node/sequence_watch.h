// Detects from the sequence numbers of each sender which samples never arrived. Independent of ROS.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <unordered_map>
#include <utility>

namespace rubber_suspension::node {

/// Follows the sequence numbers of all senders to one topic. `Sender` is a shared pointer that identifies a connection.
/// The pointer is stored, so that no later connection can have the address of an ended connection. When a new sender
/// appears, pointers without another owner are dropped. Memory is allocated only then.
template <class Sender>
class SequenceWatch {
 public:
  /// Returns how many numbers a sender skipped since its last number. Losses before its first number are unknown.
  std::uint32_t take(const Sender& sender, std::uint32_t sequence) {
    const auto known = entries_.find(sender.get());
    if (known == entries_.end()) {
      dropEnded();
      entries_.emplace(sender.get(), Entry{sender, sequence});
      return 0;
    }
    const std::uint32_t skipped = sequence - std::exchange(known->second.last, sequence) - 1;
    // If the numbers go back, the sender has restarted or counts differently, so a loss cannot be determined.
    return skipped < (1U << 31) ? skipped : 0;
  }

  std::size_t senders() const { return entries_.size(); }

 private:
  struct Entry {
    Sender sender{};
    std::uint32_t last = 0;
  };

  void dropEnded() {
    for (auto entry = entries_.begin(); entry != entries_.end();) {
      entry = entry->second.sender.use_count() == 1 ? entries_.erase(entry) : std::next(entry);
    }
  }

  std::unordered_map<const void*, Entry> entries_;
};

}  // namespace rubber_suspension::node
