// Lost samples by sequence numbers.
#include "node/sequence_watch.h"

#include <gtest/gtest.h>

namespace rubber_suspension {
namespace {

TEST(SequenceWatch, CountsWhatASenderSkips) {
  node::SequenceWatch watch;
  const int sender = 0;
  EXPECT_EQ(watch.take(&sender, 5), 0U);  // what came before the first is not known
  EXPECT_EQ(watch.take(&sender, 6), 0U);
  EXPECT_EQ(watch.take(&sender, 10), 3U);
}

TEST(SequenceWatch, KeepsSendersApart) {
  node::SequenceWatch watch;
  const int senders[2] = {};
  for (std::uint32_t i = 0; i < 10; ++i) {
    EXPECT_EQ(watch.take(&senders[0], i), 0U);
    EXPECT_EQ(watch.take(&senders[1], 100 + i), 0U);
  }
}

TEST(SequenceWatch, ASenderThatStartsAnewLosesNothing) {
  node::SequenceWatch watch;
  const int sender = 0;
  watch.take(&sender, 1000);
  EXPECT_EQ(watch.take(&sender, 0), 0U);
  EXPECT_EQ(watch.take(&sender, 0), 0U);  // one that does not count at all
  EXPECT_EQ(watch.take(&sender, 1), 0U);
}

TEST(SequenceWatch, CountsOverTheEndOfTheNumbers) {
  node::SequenceWatch watch;
  const int sender = 0;
  watch.take(&sender, 0xFFFFFFFEU);
  EXPECT_EQ(watch.take(&sender, 1), 2U);
}

TEST(SequenceWatch, ForgetsTheSenderSilentForLongest) {
  node::SequenceWatch watch;
  const int senders[20] = {};
  for (const int& sender : senders) {
    EXPECT_EQ(watch.take(&sender, 1), 0U);
  }
  EXPECT_EQ(watch.take(&senders[19], 3), 1U);
  EXPECT_EQ(watch.take(&senders[0], 3), 0U);
}

}  // namespace
}  // namespace rubber_suspension
