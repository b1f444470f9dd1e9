// The count of lost messages equals the number that queues report as dropped, for any subscriber.
#include "node/loss_count.h"

#include <deque>

#include "support/test.h"

namespace rubber_suspension {
namespace {

using Buffer = node::LossCount::Buffer;

// A subscriber as in roscpp: a queue that drops its oldest message, and one message in transmission.
class Subscriber {
 public:
  explicit Subscriber(std::size_t queue_size) : queue_size_(queue_size) {}

  // Returns true if a message was dropped.
  bool enqueue(const Buffer& message) {
    const bool full = queue_.size() >= queue_size_;
    if (full) {
      queue_.pop_front();
    }
    queue_.push_back(message);
    startSending();
    return full;
  }

  // Completes the transmission of a message and begins the next.
  void send() {
    sending_.reset();
    startSending();
  }

 private:
  void startSending() {
    if (!sending_ && !queue_.empty()) {
      sending_ = queue_.front();
      queue_.pop_front();
    }
  }

  std::size_t queue_size_;
  std::deque<Buffer> queue_;
  std::optional<Buffer> sending_;
};

// Drives three subscribers, each of which reads on average `pace` messages per published one. Returns how many messages
// were lost to at least one of them.
std::size_t drive(std::size_t queue_size, const std::array<double, 3>& pace, int messages, unsigned seed) {
  std::vector<Subscriber> subscribers(3, Subscriber(queue_size));
  node::LossCount losses(queue_size);
  std::size_t counted = 0;
  std::size_t lost = 0;
  std::mt19937 random(seed);
  for (int i = 0; i < messages; ++i) {
    const Buffer message(new std::uint8_t[1]);
    losses.begin(message);
    bool any = false;
    for (Subscriber& subscriber : subscribers) {
      any = subscriber.enqueue(message) || any;
    }
    lost += any ? 1 : 0;
    counted += losses.end() ? 1 : 0;
    for (std::size_t s = 0; s < subscribers.size(); ++s) {
      for (int reads = std::poisson_distribution<int>(pace[s])(random); reads > 0; --reads) {
        subscribers[s].send();
      }
    }
  }
  EXPECT_EQ(counted, lost) << "queue of " << queue_size;
  return counted;
}

TEST(LossCount, ExactAtAnyPaceAndLength) {
  EXPECT_EQ(drive(20, {2.0, 0.0, 2.0}, 2000, 1), 2000U - 21U);  // all but the queue and the message in transmission
  std::size_t most = 0;
  for (const std::size_t queue_size : {2U, 3U, 7U, 50U}) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const double pace = 0.1 * static_cast<double>(seed);
      most = std::max(most, drive(queue_size, {pace, 1.0, 0.9}, 1000, seed));
    }
  }
  EXPECT_GT(most, 500U);
}

TEST(LossCount, KeepsNothingThatNoQueueKeeps) {
  std::size_t kept = 0;
  const auto message = [&kept] {
    ++kept;
    return Buffer(new std::uint8_t[1], [&kept](const std::uint8_t* data) {
      --kept;
      delete[] data;
    });
  };
  node::LossCount losses(1000);
  const auto add = [&](int messages) {
    for (int i = 0; i < messages; ++i) {
      losses.begin(message());
      EXPECT_LE(kept, 1001U);
    }
  };
  add(100);
  EXPECT_LE(kept, 1U);
  // A message whose transmission never ends keeps at most a queue of other messages alive.
  const Buffer stuck = message();
  losses.begin(stuck);
  add(5001);
  EXPECT_LE(kept, 2U);
}

}  // namespace
}  // namespace rubber_suspension
