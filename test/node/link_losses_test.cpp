// Losses of each subscriber, against queues that count what they drop themselves.
#include "node/link_losses.h"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <optional>
#include <random>
#include <vector>

namespace rubber_suspension {
namespace {

using Buffer = node::LinkLosses::Buffer;

// A subscriber as roscpp serves it: a queue that drops its oldest, and one message that is being sent out of it.
class Subscriber {
 public:
  explicit Subscriber(std::size_t queue_size) : queue_size_(queue_size) {}

  void enqueue(const Buffer& message) {
    if (queue_.size() >= queue_size_) {
      queue_.pop_front();
      ++lost;
    }
    queue_.push_back(message);
    startSending();
  }

  // What is being sent has been sent, and the next begins.
  void send() {
    sending_.reset();
    startSending();
  }

  std::size_t lost = 0;

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

Buffer makeBuffer() { return Buffer(new std::uint8_t[1]); }

// Three subscribers, each with a mean number of messages that it reads for each that comes.
std::array<std::size_t, 3> drive(std::size_t queue_size, const std::array<double, 3>& pace, int messages,
                                 unsigned seed) {
  std::vector<Subscriber> subscribers(3, Subscriber(queue_size));
  node::LinkLosses losses(queue_size);
  std::array<std::size_t, 3> counted{};
  std::mt19937 random(seed);
  for (int i = 0; i < messages; ++i) {
    const Buffer message = makeBuffer();
    losses.begin(message);
    for (std::size_t s = 0; s < subscribers.size(); ++s) {
      subscribers[s].enqueue(message);
      counted[s] += losses.passed();
    }
    for (std::size_t s = 0; s < subscribers.size(); ++s) {
      for (int reads = std::poisson_distribution<int>(pace[s])(random); reads > 0; --reads) {
        subscribers[s].send();
      }
    }
  }
  for (std::size_t s = 0; s < subscribers.size(); ++s) {
    EXPECT_EQ(counted[s], subscribers[s].lost) << "subscriber " << s << ", queue of " << queue_size;
  }
  return counted;
}

TEST(LinkLosses, EachSubscriberHasItsOwn) {
  const auto lost = drive(20, {2.0, 0.0, 0.5}, 2000, 1);
  EXPECT_EQ(lost[0], 0U);
  EXPECT_EQ(lost[1], 2000U - 21U);  // all but a queue and the one that is being sent
  EXPECT_GT(lost[2], 500U);
}

TEST(LinkLosses, ExactAtAnyPaceAndLength) {
  std::size_t most = 0;
  for (const std::size_t queue_size : {2U, 3U, 7U, 50U}) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const double pace = 0.1 * static_cast<double>(seed);
      most = std::max(most, drive(queue_size, {pace, 1.0, 0.9}, 1000, seed)[0]);
    }
  }
  EXPECT_GT(most, 500U);
}

TEST(LinkLosses, KeepsNothingThatNoQueueKeeps) {
  node::LinkLosses losses(1000);
  for (int i = 0; i < 100; ++i) {
    losses.begin(makeBuffer());
  }
  EXPECT_LE(losses.waiting(), 1U);
  // One that is sent forever keeps no others alive beyond a queue.
  const Buffer stuck = makeBuffer();
  losses.begin(stuck);
  for (int i = 0; i < 5000; ++i) {
    losses.begin(makeBuffer());
    EXPECT_LE(losses.waiting(), 1001U);
  }
  losses.begin(makeBuffer());
  EXPECT_LE(losses.waiting(), 1U);
}

}  // namespace
}  // namespace rubber_suspension
