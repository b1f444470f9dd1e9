// Sets that a set of effects is compared with.
#include "diagnosis/hypotheses/sets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rubber_suspension::diagnosis {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The law of 2 contains those of 0 and 1, that of 3 those of 4 and 5, and that of 4 that of 5.
const Sets kContained = {{}, {}, {0, 1}, {4, 5}, {5}, {}};

TEST(Sets, HaveASimplerLawInThePlaceOfOneThatContainsIt) {
  EXPECT_THAT(withSimplerLaws({2, 5}, kContained), ElementsAre(ElementsAre(0, 5), ElementsAre(1, 5)));
  EXPECT_THAT(withSimplerLaws({3}, kContained), ElementsAre(ElementsAre(4), ElementsAre(5)));
}

TEST(Sets, NameNoEffectTwice) {
  EXPECT_THAT(withSimplerLaws({0, 2}, kContained), ElementsAre(ElementsAre(0, 1)));
  EXPECT_THAT(withLawsApart({0, 2}, kContained), IsEmpty());
}

TEST(Sets, TakeApartALawThatContainsSeveral) {
  EXPECT_THAT(withLawsApart({2, 5}, kContained), ElementsAre(ElementsAre(0, 1, 5)));
}

TEST(Sets, TakeNoChainApart) { EXPECT_THAT(withLawsApart({3}, kContained), IsEmpty()); }

TEST(Sets, AreWithoutOneInTurn) {
  EXPECT_THAT(withoutOne({1, 3, 4}), ElementsAre(ElementsAre(3, 4), ElementsAre(1, 4), ElementsAre(1, 3)));
}

}  // namespace
}  // namespace rubber_suspension::diagnosis
