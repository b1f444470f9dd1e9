// Lost samples are counted by sequence numbers.
#include "node/sequence_watch.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

using Sender = std::shared_ptr<int>;
using Watch = node::SequenceWatch<Sender>;

TEST(SequenceWatch, CountsWhatASenderSkips) {
  Watch watch;
  const auto sender = std::make_shared<int>();
  EXPECT_EQ(watch.take(sender, 5), 0U);  // losses before the first sample are unknown
  EXPECT_EQ(watch.take(sender, 6), 0U);
  EXPECT_EQ(watch.take(sender, 10), 3U);
}

TEST(SequenceWatch, KeepsSendersApart) {
  Watch watch;
  const Sender senders[2] = {std::make_shared<int>(), std::make_shared<int>()};
  for (std::uint32_t i = 0; i < 10; ++i) {
    EXPECT_EQ(watch.take(senders[0], i), 0U);
    EXPECT_EQ(watch.take(senders[1], 100 + i), 0U);
  }
}

TEST(SequenceWatch, ASenderThatStartsAnewLosesNothing) {
  Watch watch;
  const auto sender = std::make_shared<int>();
  watch.take(sender, 1000);
  EXPECT_EQ(watch.take(sender, 0), 0U);
  EXPECT_EQ(watch.take(sender, 0), 0U);  // a sender whose numbers do not increase
  EXPECT_EQ(watch.take(sender, 1), 0U);
}

TEST(SequenceWatch, CountsOverTheEndOfTheNumbers) {
  Watch watch;
  const auto sender = std::make_shared<int>();
  watch.take(sender, 0xFFFFFFFEU);
  EXPECT_EQ(watch.take(sender, 1), 2U);
}

// Twenty senders take turns, and each loses every second sample.
TEST(SequenceWatch, CountsForAsManySendersAsThereAre) {
  Watch watch;
  std::vector<Sender> senders(20);
  for (Sender& sender : senders) {
    sender = std::make_shared<int>();
  }
  std::uint32_t lost = 0;
  for (std::uint32_t i = 0; i < 10; ++i) {
    for (const Sender& sender : senders) {
      lost += watch.take(sender, 2 * i);
    }
  }
  EXPECT_EQ(lost, 20U * 9U);
}

// Senders come and go. A new sender must not be mistaken for a former one, even if its address is the same.
TEST(SequenceWatch, TakesNoNewSenderForOneThatWent) {
  Watch watch;
  std::uint32_t lost = 0;
  for (std::uint32_t visit = 0; visit < 1000; ++visit) {
    const auto sender = std::make_shared<int>();
    for (std::uint32_t i = 0; i < 3; ++i) {
      lost += watch.take(sender, 1000003U * visit + i);
    }
  }
  EXPECT_EQ(lost, 0U);
  EXPECT_LE(watch.senders(), 2U);  // former senders are removed
}

// The null pointer is a valid sender.
TEST(SequenceWatch, TheEmptySenderIsOneOfThem) {
  Watch watch;
  EXPECT_EQ(watch.take(nullptr, 7), 0U);
  EXPECT_EQ(watch.take(nullptr, 9), 1U);
}

}  // namespace
}  // namespace rubber_suspension
