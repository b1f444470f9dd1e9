// Notices samples that were sent but never arrived, by the sequence number of each sender. Independent of ROS.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <unordered_map>
#include <utility>

namespace rubber_suspension::node {

/// Follows the sequence numbers of all senders to one topic. `Sender` is a shared pointer that identifies a connection.
/// It is stored, so that no later connection can have the address of one that has ended; those without another owner
/// are dropped when a new one comes. Allocates only then.
template <class Sender>
class SequenceWatch {
 public:
  /// Returns how many numbers a sender skipped since its last one. Losses before its first number are unknown.
  std::uint32_t take(const Sender& sender, std::uint32_t sequence) {
    const auto known = entries_.find(sender.get());
    if (known == entries_.end()) {
      dropEnded();
      entries_.emplace(sender.get(), Entry{sender, sequence});
      return 0;
    }
    const std::uint32_t skipped = sequence - std::exchange(known->second.last, sequence) - 1;
    // A sender whose numbers go back counts again from the start or in its own way: no loss is known.
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
