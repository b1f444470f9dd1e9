// Notices samples that were sent but never arrived.
#include "node/sequence_watch.h"

namespace rubber_suspension::node {

std::uint32_t SequenceWatch::take(const void* sender, std::uint32_t sequence) {
  ++clock_;
  Sender* place = &senders_[0];
  for (Sender& known : senders_) {
    if (known.address == sender) {
      const std::uint32_t skipped = sequence - known.last - 1;
      known.last = sequence;
      known.used = clock_;
      // A number that goes back is a sender that started anew or counts in its own way: nothing is known to be lost.
      return skipped < (1U << 31) ? skipped : 0;
    }
    if (known.used < place->used) {
      place = &known;
    }
  }
  *place = {sender, sequence, clock_};
  return 0;
}

}  // namespace rubber_suspension::node
