// Suggestions for misspelt words, and words for which there is no suggestion.
#include "element/suggestion.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(EditDistance, CountsChangesOfLetters) {
  EXPECT_EQ(element::editDistance("", ""), 0u);
  EXPECT_EQ(element::editDistance("", "spring"), 6u);
  EXPECT_EQ(element::editDistance("spring", "spring"), 0u);
  EXPECT_EQ(element::editDistance("sprung", "spring"), 1u);   // one letter changed
  EXPECT_EQ(element::editDistance("sping", "spring"), 1u);    // one letter missing
  EXPECT_EQ(element::editDistance("sprring", "spring"), 1u);  // one letter added
  EXPECT_EQ(element::editDistance("srping", "spring"), 1u);   // two letters swapped
  EXPECT_EQ(element::editDistance("SPRING", "spring"), 0u);   // other case
  EXPECT_EQ(element::editDistance("kitten", "sitting"), 3u);
}

TEST(EditDistance, IsTheSameBothWays) {
  for (const char* word : {"", "kN", "friction", "frcition", "maximum_force"}) {
    EXPECT_EQ(element::editDistance(word, "friction"), element::editDistance("friction", word)) << word;
  }
}

TEST(NearestWord, IsTheNearestOfThoseKnown) {
  const std::vector<std::string> keys = {"static_stiffness", "dynamic_stiffness", "force_zero", "spring", "springpot"};
  EXPECT_EQ(element::nearestWord("static_stifness", keys), "static_stiffness");
  EXPECT_EQ(element::nearestWord("dyanmic_stiffnes", keys), "dynamic_stiffness");
  EXPECT_EQ(element::nearestWord("Spring", keys), "spring");
  EXPECT_EQ(element::nearestWord("zero", keys), "force_zero");  // one whole word of the key
}

TEST(NearestWord, IsNothingWhereNoneIsNear) {
  const std::vector<std::string> keys = {"static_stiffness", "dynamic_stiffness", "spring", "m"};
  EXPECT_FALSE(element::nearestWord("magic", keys));
  EXPECT_FALSE(element::nearestWord("", keys));
  EXPECT_FALSE(element::nearestWord("spring", keys));     // a known key
  EXPECT_FALSE(element::nearestWord("stiffness", keys));  // a word of two keys
  EXPECT_FALSE(element::nearestWord("s", keys));          // too short for a suggestion
  EXPECT_FALSE(element::nearestWord(std::string(100000, 's'), keys));
}

TEST(DidYouMean, IsPutBehindWhatIsWrong) {
  EXPECT_EQ(element::didYouMean("frction", {"spring", "friction"}), " (did you mean 'friction'?)");
  EXPECT_EQ(element::didYouMean("magic", {"spring", "friction"}), "");
}

}  // namespace
}  // namespace rubber_suspension
