// Statements about the residual force that no effect explains, and the surrogate for it.
#include "diagnosis/results/surrogate.h"

#include <nlohmann/json.hpp>

#include "diagnosis/words/sentence.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/replay.h"
#include "shared_runs.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kFloor = 0.01;

/// Judges six held-out blocks per log. Their gap falls from 0.1 to the value given for their log.
Surrogate judged(const std::vector<double>& after) {
  std::vector<fit::UnseenBlock> unseen;
  for (std::size_t log = 0; log < after.size(); ++log) {
    for (int block = 0; block < 6; ++block) {
      const double scatter = 1.0 + 0.02 * (block - 2.5);
      unseen.push_back({static_cast<int>(log), 1.0 / 6.0, 0.01 * scatter, std::pow(after[log], 2) * scatter});
    }
  }
  Surrogate surrogate;
  results::judgeRest(unseen, kFloor, true, surrogate);
  return surrogate;
}

TEST(JudgeRest, WhatIsPredictedInEachLogIsAFunctionOfTheMotion) {
  const Surrogate surrogate = judged({0.02, 0.025, 0.03});
  EXPECT_TRUE(surrogate.function_of_the_motion);
  // The mean square of the gaps is 6.4167e-4. The noise floor has a square of 1e-4, and the gap before one of 1e-2.
  EXPECT_NEAR(surrogate.share, 1.0 - 5.4167e-4 / 99e-4, 1e-4);
  EXPECT_THAT(words::restNote(surrogate), HasSubstr("depends on the motion by a law that is not in the list"));
  EXPECT_THAT(words::restNote(surrogate), HasSubstr("predicts 95 %"));
}

TEST(JudgeRest, ASmallPartOfItIsCalledThat) {
  const Surrogate surrogate = judged({0.085, 0.09, 0.088});
  EXPECT_FALSE(surrogate.function_of_the_motion);
  EXPECT_LT(surrogate.chance, 0.05);
  EXPECT_THAT(words::restNote(surrogate), HasSubstr("Only part of the rest"));
}

TEST(JudgeRest, WhatIsNotPredictedIsNoFunctionOfTheMotion) {
  const Surrogate surrogate = judged({0.1, 0.101, 0.0999});
  EXPECT_FALSE(surrogate.function_of_the_motion);
  EXPECT_THAT(words::restNote(surrogate), HasSubstr("do not show whether the motion causes the rest"));
}

// A noise floor above the residual must be wrong. It must not make the whole residual count as predicted.
TEST(JudgeRest, AFloorAboveWhatIsLeftDoesNotCount) {
  const Surrogate surrogate = judged({0.0099, 0.0099, 0.0099});
  EXPECT_NEAR(surrogate.share, 1.0 - 0.0099 * 0.0099 / 0.01, 1e-6);
}

// A large improvement in one log of three is no evidence for the others.
TEST(JudgeRest, OneLogOfThreeIsNotEnough) {
  const Surrogate surrogate = judged({0.005, 0.1, 0.1});
  EXPECT_FALSE(surrogate.function_of_the_motion);
  EXPECT_GT(surrogate.chance, 0.05);
}

// Force of a cable that catches on its guide every 1 mm: an unlisted function of the displacement alone.
double catchingCable(double /*time*/, double z, double /*rate*/) { return 150.0 * std::sin(2e3 * element::kPi * z); }

double replayedGap(const io::ComponentDescription& component, const log::Log& log) {
  return gap::relativeGap(log.force, gap::replay(component.makeComponent(), log).force);
}

class UnlistedEffect : public testing::Test {
 protected:
  static void SetUpTestSuite() { result() = std::make_unique<Diagnosis>(diagnoseRig(catchingCable)); }
  static void TearDownTestSuite() { result().reset(); }
  static std::unique_ptr<Diagnosis>& result() {
    static std::unique_ptr<Diagnosis> diagnosis;
    return diagnosis;
  }
};

TEST_F(UnlistedEffect, IsSeenToBeAFunctionOfTheMotion) {
  ASSERT_TRUE(result()->surrogate) << result()->sentence;
  EXPECT_TRUE(result()->surrogate->function_of_the_motion) << result()->sentence;
  EXPECT_THAT(result()->sentence, HasSubstr("The rest depends on the motion"));
}

// On the held-out log the surrogate must close at least 60 % of the gap beyond the noise.
TEST_F(UnlistedEffect, IsClosedByTheSurrogateOnAnUnseenLog) {
  ASSERT_TRUE(result()->surrogate);
  const log::Log unseen = runRig("unseen", 3, catchingCable);
  const double before = replayedGap(result()->law.augmented, unseen);
  const double after = replayedGap(result()->surrogate->component, unseen);
  const double floor = result()->gaps.unseen.noise_floor;
  EXPECT_LT(after - floor, 0.4 * (before - floor)) << before << " to " << after << ", floor " << floor;
}

// The gap that the report states is accurate to 0.1 % of the force.
TEST_F(UnlistedEffect, ReplayOfTheSurrogateFileGivesTheClaimedGap) {
  ASSERT_TRUE(result()->surrogate);
  const ScratchFolder folder;
  writeReport(*result(), folder.path());
  const auto components = io::loadComponentFile(folder.path("surrogate.yaml"));
  const auto report = nlohmann::json::parse(std::ifstream(folder.path("report.json")));
  const auto& claim = report.at("surrogate");
  EXPECT_EQ(claim.at("file"), "surrogate.yaml");
  EXPECT_EQ(claim.at("function_of_the_motion"), true);
  EXPECT_NEAR(replayedGap(components.front(), runRig("unseen", 3, catchingCable)), claim.at("gap").get<double>(), 1e-3);
  std::ifstream map(folder.path("missing_force.csv"));
  std::string header;
  std::getline(map, header);
  EXPECT_EQ(header, "displacement_m,velocity_m_per_s,missing_force_N,surrogate_force_N,samples");
}

// The map of the missing force agrees with the force of the surrogate.
TEST_F(UnlistedEffect, TheMapShowsWhatIsMissingAndThatTheSurrogateHasIt) {
  ASSERT_TRUE(result()->surrogate);
  const MissingForce& map = result()->surrogate->missing;
  double missing = 0.0;
  double left = 0.0;
  for (std::size_t cell = 0; cell < map.measured.size(); ++cell) {
    if (!std::isnan(map.measured[cell])) {
      missing += map.samples[cell] * std::pow(map.measured[cell], 2);
      left += map.samples[cell] * std::pow(map.measured[cell] - map.surrogate[cell], 2);
    }
  }
  EXPECT_GT(missing, 0.0);
  EXPECT_LT(left, 0.1 * missing);
}

TEST(SurrogateOfHum, IsNoFunctionOfTheMotion) {
  const Diagnosis& result = ofHum();
  ASSERT_EQ(result.answer.verdict, diagnosis::Verdict::unknown);
  ASSERT_TRUE(result.surrogate);
  EXPECT_FALSE(result.surrogate->function_of_the_motion) << result.sentence;
  EXPECT_THAT(result.sentence, HasSubstr("do not show whether the motion causes the rest"));
  // The surrogate may be at most 1 % worse than the augmented component.
  EXPECT_LT(result.surrogate->gap, 1.01 * result.gap_as_recorded.augmented);
}

TEST(SurrogateOfNothing, IsNotWritten) { EXPECT_FALSE(ofNothing().surrogate); }

}  // namespace
}  // namespace rubber_suspension::diagnosis
