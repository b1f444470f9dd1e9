// Bounds of messages on the wire: valid messages pass; short or long messages and excessive sizes are refused.
#include "node/message_bounds.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, std::size_t number) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(number >> shift));
  }
}

void append(Bytes& bytes, const std::string& text) {
  append(bytes, text.size());
  bytes.insert(bytes.end(), text.begin(), text.end());
}

Bytes header(std::size_t frame = 3) {
  Bytes bytes(12, 0);
  append(bytes, std::string(frame, 'f'));
  return bytes;
}

Bytes sample(std::size_t frame = 3) {
  Bytes bytes = header(frame);
  bytes.resize(bytes.size() + 8);
  return bytes;
}

Bytes bundle(const std::vector<std::string>& names, std::size_t numbers) {
  Bytes bytes = header();
  append(bytes, names.size());
  for (const std::string& name : names) {
    append(bytes, name);
  }
  append(bytes, numbers);
  bytes.resize(bytes.size() + 8 * numbers);
  return bytes;
}

bool isSample(const Bytes& bytes) { return node::isStamped<1>(bytes.data(), bytes.size()); }
bool isBundle(const Bytes& bytes, std::size_t most = 3) { return node::isBundle(bytes.data(), bytes.size(), most); }

TEST(MessageBounds, ASampleIsOneToTheLastByte) {
  const Bytes whole = sample();
  EXPECT_TRUE(isSample(whole));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(node::isStamped<1>(whole.data(), size));
  }
  Bytes longer = whole;
  longer.push_back(0);
  EXPECT_FALSE(isSample(longer));
}

TEST(MessageBounds, TheFrameIsBounded) {
  EXPECT_TRUE(isSample(sample(0)));
  EXPECT_TRUE(isSample(sample(node::kLongestFrameId)));
  EXPECT_FALSE(isSample(sample(node::kLongestFrameId + 1)));
}

TEST(MessageBounds, ABundleIsOneToTheLastByte) {
  for (const Bytes& whole : {bundle({"a", "bb", "ccc"}, 3), bundle({}, 3), bundle({}, 0), bundle({"a"}, 2)}) {
    EXPECT_TRUE(isBundle(whole));
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_FALSE(node::isBundle(whole.data(), size, 3));
    }
    Bytes longer = whole;
    longer.push_back(0);
    EXPECT_FALSE(isBundle(longer));
  }
}

TEST(MessageBounds, ABundleHasNoMoreThanThereAreComponents) {
  EXPECT_FALSE(isBundle(bundle({"a", "b", "c"}, 3), 2));
  EXPECT_FALSE(isBundle(bundle({}, 3), 2));
  EXPECT_FALSE(isBundle(bundle({std::string(node::kLongestComponentName + 1, 'a')}, 1)));
}

TEST(MessageBounds, WhatAMessageClaimsIsHeldAgainstWhatItHas) {
  for (const std::size_t claim : {std::size_t{1} << 28U, std::size_t{1} << 31U, (std::size_t{1} << 32U) - 1}) {
    Bytes numbers = header();
    append(numbers, std::size_t{0});
    append(numbers, claim);
    EXPECT_FALSE(isBundle(numbers, claim));
    Bytes names = header();
    append(names, claim);
    EXPECT_FALSE(isBundle(names, claim));
  }
}

TEST(MessageBounds, TheLongestBundleIsAsLongAsItSays) {
  Bytes longest = header(node::kLongestFrameId);
  const std::vector<std::string> names(5, std::string(node::kLongestComponentName, 'n'));
  const Bytes body = bundle(names, names.size());
  longest.insert(longest.end(), body.begin() + static_cast<std::ptrdiff_t>(header().size()), body.end());
  EXPECT_TRUE(isBundle(longest, names.size()));
  EXPECT_EQ(longest.size(), node::longestBundle(names.size()));
}

}  // namespace
}  // namespace rubber_suspension
