// What types of different stiffness on one rig decide, on draws of known truth, and how often they decide wrongly.
#include "campaign/rig_stiffness.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <random>

namespace rubber_suspension {
namespace {

using campaign::RigCause;
using campaign::RigJudgement;
using campaign::TypeOnRig;

constexpr double kScatter = 0.04;        // of the hardness of a test piece, which moves all its stiffnesses
constexpr double kScatterOfEach = 0.02;  // of one stiffness on top

class Rigs : public ::testing::Test {
 protected:
  /// Static, dynamic and maximum stiffness; `expected` gives the logarithm of measured over configured value.
  TypeOnRig draw(double stiffness, const std::function<double(double)>& expected, int components = 12) {
    TypeOnRig type;
    type.stiffness = {stiffness, 1.35 * stiffness, 1.75 * stiffness};
    for (int i = 0; i < components; ++i) {
      const double hardness = kScatter * normal_(generator_);
      std::vector<double> row;
      for (const double configured : type.stiffness) {
        row.push_back(expected(configured) + hardness + kScatterOfEach * normal_(generator_));
      }
      type.logarithms.push_back(row);
    }
    return type;
  }

  std::vector<TypeOnRig> drawRig(const std::function<double(double)>& expected) {
    return {draw(1e6, expected), draw(2e6, expected), draw(5e6, expected)};
  }

  std::mt19937 generator_{5};
  std::normal_distribution<double> normal_;
};

std::function<double(double)> behind(double compliance) {
  return [compliance](double stiffness) { return -std::log1p(compliance * stiffness); };
}

TEST_F(Rigs, ThatGiveWayAreTold) {
  int missed = 0;
  for (int i = 0; i < 40; ++i) {
    const auto judgement = campaign::judgeRig(drawRig(behind(3e-8)));
    ASSERT_TRUE(judgement);
    EXPECT_GT(judgement->probability(RigCause::compliance), 0.95);
    missed += judgement->compliance_interval[0] > 3e-8 || judgement->compliance_interval[1] < 3e-8 ? 1 : 0;
  }
  EXPECT_LE(missed, 7);  // of 40 intervals of 95 % two miss, give or take 1.4: four times that on top
}

TEST_F(Rigs, OfAWrongGainAreTold) {
  const auto judgement = campaign::judgeRig(drawRig([](double) { return -0.08; }));
  EXPECT_GT(judgement->probability(RigCause::factor), 0.9);
}

TEST_F(Rigs, ThatAreRightAreTold) {
  double right = 0.0;
  for (int i = 0; i < 40; ++i) {
    const auto judgement = campaign::judgeRig(drawRig([](double) { return 0.0; }));
    right += judgement->probability(RigCause::none) / 40.0;
    EXPECT_LT(judgement->probability(RigCause::compliance), 0.95);
  }
  EXPECT_GT(right, 0.5);  // a small compliance or factor looks alike
}

// Types whose values are wrong each in its own way are taken for a soft rig where chance puts them in line. At 95 %,
// one decision of twenty may be wrong; here the wrong ones are counted among all rigs, which are more.
TEST_F(Rigs, WithTypesThatAreWrongEachOnItsOwnAreRarelyTakenForSoft) {
  int wrong = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<TypeOnRig> types;
    for (const double stiffness : {1e6, 2e6, 5e6}) {
      const double factor = 0.07 * normal_(generator_);
      types.push_back(draw(stiffness, [&](double) { return factor; }));
    }
    wrong += campaign::judgeRig(types)->probability(RigCause::compliance) >= 0.95 ? 1 : 0;
  }
  EXPECT_LE(wrong, 20);
}

TEST_F(Rigs, SayNothingOfTypesTooAlikeTooFewOrTooSmall) {
  const auto soft = behind(3e-8);
  EXPECT_FALSE(campaign::judgeRig({}));
  EXPECT_FALSE(campaign::judgeRig({draw(1e6, soft)}));
  EXPECT_FALSE(campaign::judgeRig({draw(1e6, soft), draw(1.4e6, soft)}));
  EXPECT_FALSE(campaign::judgeRig({draw(1e6, soft), draw(5e6, soft, 4)}));
  EXPECT_TRUE(campaign::judgeRig({draw(1e6, soft), draw(5e6, soft, 5)}));
}

TEST(Compliance, IsGivenBack) {
  // Springs in series: 1/measured = 1/true + compliance; with 4e6 N/m and 5e-8 m/N that is 10/3 e6 N/m.
  const double configured = 3.5e6;
  const auto logarithm = campaign::withoutCompliance(std::log(1e7 / 3.0 / configured), configured, 5e-8);
  ASSERT_TRUE(logarithm);
  EXPECT_NEAR(configured * std::exp(*logarithm), 4e6, 1.0);
  EXPECT_FALSE(campaign::withoutCompliance(0.0, 4e6, 3e-7));  // the rig alone would be softer
}

}  // namespace
}  // namespace rubber_suspension
