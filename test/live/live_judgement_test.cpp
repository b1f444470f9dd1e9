// The judgement while a bench runs: the inequality of the evidence, the onset, and the rules for naming effects.
#include "diagnosis/live/live_judgement.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

using diagnosis::live::LiveJudgement;
using diagnosis::live::SequentialEvidence;

// In the worst case, every bet is fair. Then at most a share n/c of the runs with n bets may reach an evidence of c.
TEST(SequentialEvidence, KeepsItsInequalityWhereEveryBetIsFair) {
  constexpr int kRuns = 400;
  constexpr int kBets = 20000;
  constexpr double kThreshold = 2e5;  // so that at most one run in ten may reach it
  std::mt19937 random(1);
  int reached = 0;
  for (int run = 0; run < kRuns; ++run) {
    SequentialEvidence evidence(kThreshold);
    bool once = false;
    for (int bet = 0; bet < kBets; ++bet) {
      evidence.add((random() & 1U) != 0U);
      once = once || evidence.isReached();
    }
    reached += once ? 1 : 0;
  }
  // If the share were at its bound, 40 runs would be expected, with a standard deviation of 6.
  EXPECT_LE(reached, 58);
  EXPECT_GE(reached, 1) << "a bound that is never approached would make a test that cannot fail";
}

TEST(SequentialEvidence, ForgetsBetsLostBeforeTheEffect) {
  SequentialEvidence evidence(diagnosis::live::LiveCriteria().threshold());
  for (int i = 0; i < 100000; ++i) {
    evidence.add(false);
  }
  int needed = 0;
  for (; !evidence.isReached(); ++needed) {
    evidence.add(true);
  }
  // The evidence needs log(3.6e6)/log(1.8) = 25.7 blocks of a second. An effect must be named within two minutes.
  EXPECT_EQ(needed, 26);
}

std::vector<double> steps(const std::vector<std::pair<int, double>>& stretches, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> deviation(0.0, noise);
  std::vector<double> values;
  for (const auto& [count, level] : stretches) {
    for (int i = 0; i < count; ++i) {
      values.push_back(level + deviation(random));
    }
  }
  return values;
}

TEST(Onset, IsWhereTheLevelChanges) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto change = diagnosis::live::mostLikelyChange(steps({{200, 0.0}, {20, 0.5}}, 0.15, seed));
    ASSERT_TRUE(change) << seed;
    EXPECT_NEAR(static_cast<double>(change->first), 200.0, 3.0) << seed;
    EXPECT_GT(change->after, change->before);
  }
}

TEST(Onset, IsTheLastOfSeveral) {
  const auto change = diagnosis::live::lastChange(steps({{100, 0.0}, {80, 1.0}, {60, 0.4}}, 0.1, 7));
  ASSERT_TRUE(change);
  EXPECT_NEAR(static_cast<double>(change->first), 180.0, 2.0);
  EXPECT_LT(change->after, change->before);
}

TEST(Onset, IsNotFoundInNoise) {
  int found = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    found += diagnosis::live::lastChange(steps({{400, 0.0}}, 0.15, seed)) ? 1 : 0;
  }
  // A false change only shortens the window of a diagnosis, so one in a hundred is acceptable.
  EXPECT_LE(found, 3);
}

constexpr std::int64_t kSecond = 1000000000;

diagnosis::live::BlockErrors block(int second, double configured, double augmented = std::nan("")) {
  return {second * kSecond, 1000.0, configured, configured, augmented};
}

TEST(LiveJudgement, NamesAnEffectOnceTheBlocksConfirmItAndTellsTheOnset) {
  LiveJudgement judgement;
  EXPECT_EQ(judgement.now().verdict, std::nullopt);
  judgement.addLook({diagnosis::Verdict::none, {}});
  EXPECT_EQ(judgement.now().verdict, diagnosis::Verdict::none);
  const std::vector<double> noise = steps({{200, 1.0}}, 0.05, 3);
  for (int i = 0; i < 100; ++i) {
    judgement.addBlock(block(i, 10.0 * noise[static_cast<std::size_t>(i)]));
  }
  for (int i = 100; i < 120; ++i) {
    judgement.addBlock(block(i, 30.0 * noise[static_cast<std::size_t>(i)]));
  }
  judgement.addLook({diagnosis::Verdict::named, {"friction"}});
  EXPECT_EQ(judgement.now().verdict, std::nullopt) << "a look alone names nothing";
  for (int i = 120; i < 145; ++i) {
    judgement.addBlock(block(i, 30.0 * noise[static_cast<std::size_t>(i)], 11.0));
  }
  EXPECT_EQ(judgement.now().verdict, std::nullopt);
  judgement.addBlock(block(145, 30.0, 11.0));
  const diagnosis::live::LiveVerdict verdict = judgement.now();
  EXPECT_EQ(verdict.verdict, diagnosis::Verdict::named);
  EXPECT_THAT(verdict.effects, ElementsAre("friction"));
  ASSERT_TRUE(verdict.since);
  EXPECT_NEAR(static_cast<double>(*verdict.since), 100.0 * kSecond, 3.0 * kSecond);
}

TEST(LiveJudgement, AGapFromTheBeginOnHasNoOnset) {
  LiveJudgement judgement;
  judgement.addLook({diagnosis::Verdict::named, {"friction"}});
  for (int i = 0; i < 60; ++i) {
    judgement.addBlock(block(i, 30.0 + i % 3, 11.0));
  }
  EXPECT_EQ(judgement.now().verdict, diagnosis::Verdict::named);
  EXPECT_FALSE(judgement.now().since);
}

TEST(LiveJudgement, AnEffectThatDoesNotPredictIsNotNamed) {
  LiveJudgement judgement;
  for (int i = 0; i < 100000; ++i) {
    if (i % 60 == 0) {
      judgement.addLook({diagnosis::Verdict::named, {"creep"}});
    }
    judgement.addBlock(block(i, 10.0, i % 2 == 0 ? 9.9 : 10.1));  // better as often as worse
  }
  EXPECT_EQ(judgement.now().verdict, std::nullopt);
  EXPECT_THAT(judgement.now().effects, IsEmpty());
}

TEST(LiveJudgement, ANameIsTakenBackByTwoLooksThatAgree) {
  LiveJudgement judgement;
  judgement.addLook({diagnosis::Verdict::named, {"friction"}});
  for (int i = 0; i < 40; ++i) {
    judgement.addBlock(block(i, 30.0, 11.0));
  }
  judgement.addLook({diagnosis::Verdict::none, {}});
  EXPECT_EQ(judgement.now().verdict, diagnosis::Verdict::named);
  judgement.addLook({diagnosis::Verdict::partly, {"friction", "creep"}});
  EXPECT_THAT(judgement.now().effects, ElementsAre("friction", "creep"));
  judgement.addLook({diagnosis::Verdict::none, {}});
  EXPECT_EQ(judgement.now().verdict, diagnosis::Verdict::partly);
  judgement.addLook({diagnosis::Verdict::none, {}});
  EXPECT_EQ(judgement.now().verdict, diagnosis::Verdict::none);
  EXPECT_EQ(judgement.now().evidence, 1.0);
}

TEST(LiveJudgement, OtherVerdictsNeedTwoLooks) {
  for (const auto verdict :
       {diagnosis::Verdict::parameter_error, diagnosis::Verdict::unknown, diagnosis::Verdict::check_bench}) {
    LiveJudgement judgement;
    judgement.addLook({verdict, {}});
    EXPECT_EQ(judgement.now().verdict, std::nullopt);
    judgement.addLook({verdict, {}});
    EXPECT_EQ(judgement.now().verdict, verdict);
  }
}

TEST(LiveJudgement, StandstillSaysNothing) {
  LiveJudgement judgement;
  judgement.addLook({diagnosis::Verdict::named, {"friction"}});
  judgement.addBlock(block(0, 30.0, 11.0));
  const double evidence = judgement.now().evidence;
  for (int i = 1; i < 100; ++i) {
    judgement.addBlock({i * kSecond, 1.0, 1.0, 1.0, 0.5});
  }
  EXPECT_EQ(judgement.now().evidence, evidence);
}

}  // namespace
}  // namespace rubber_suspension
