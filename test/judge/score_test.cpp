// What the score takes of evidence, and what it refuses.
#include "diagnosis/judge/score.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "judge/made_evidence.h"

namespace rubber_suspension::test {
namespace {

using diagnosis::Evidence;
using diagnosis::JudgeNumbers;
using diagnosis::NamedEvidence;

TEST(ScoreTable, RefusesEvidenceWithoutLogs) {
  NamedEvidence named = unexplained(3, 2, 0.1);
  named.evidence.logs.clear();
  EXPECT_THROW(scoreTable(named), std::invalid_argument);
  named = unexplained(3, 2, 0.1);
  named.evidence.hypotheses.back().sizes.clear();
  EXPECT_THROW(scoreTable(named), std::invalid_argument);
}

// One log, so that nothing is shrunk: the weights are those of the equations in score.h, computed here by hand.
TEST(LogWeights, AreThoseOfTheEquations) {
  NamedEvidence named = unexplained(1, 1, 0.1, 50);
  explain(named, 0, 0.02);
  JudgeNumbers numbers;
  numbers.sharpness = 6.0;
  numbers.tails = 3.0;
  numbers.floor_known = 0.5;
  numbers.accepted = 0.01;
  numbers.form_error = 0.1;
  numbers.least_size = 0.001;  // below the sizes here
  numbers.per_number = 0.2;
  numbers.rest = -2.0;
  numbers.effect = -3.0;
  const diagnosis::LogWeights weights = logWeights(scoreTable(named), numbers);
  const double r2 = 0.02 * 0.02 - kFloor * kFloor;
  const double s2 = std::pow(0.5 * kFloor, 2) + 0.01 * 0.01 + 0.1 * 0.1 * (0.1 * 0.1 - 0.02 * 0.02);
  const double prior = -3.0 - 0.2 * std::log1p(5.0);
  EXPECT_NEAR(weights.alone[Evidence::kFirstSingle], -3.0 * (std::log(s2) + 4.0 * std::log1p(r2 / (3.0 * s2))) + prior,
              1e-9);
  EXPECT_NEAR(weights.beside[Evidence::kFirstSingle], -3.0 * (std::log(std::max(r2, s2)) + 1.0) - 2.0 + prior, 1e-9);
}

// Hold-out logs are further logs: a law that fails on them is not the answer.
TEST(LogWeights, CountUnseenLogs) {
  NamedEvidence named = unexplained(4, 1, 0.1);
  explain(named, 0, 0.004);
  const JudgeNumbers numbers;
  const double before = logWeights(scoreTable(named), numbers).alone[Evidence::kFirstSingle];
  named.evidence.logs.back().unseen = true;
  named.evidence.hypotheses.back().log_errors.back() = 0.1 * 0.1;
  EXPECT_LT(logWeights(scoreTable(named), numbers).alone[Evidence::kFirstSingle], before - 1.0);
}

TEST(JudgeNumbers, AreEachInTheTableOnce) {
  JudgeNumbers numbers;
  for (const diagnosis::NumberInfo& info : diagnosis::numberTable()) {
    EXPECT_EQ(numbers.*info.value, info.mean) << info.name;  // before any fit
    numbers.*info.value = -1e9;
  }
  for (const diagnosis::NumberInfo& info : diagnosis::numberTable()) {
    EXPECT_EQ(numbers.*info.value, -1e9) << info.name;
    EXPECT_TRUE(std::isfinite(diagnosis::fittedNumbers().*info.value)) << info.name;
  }
}

}  // namespace
}  // namespace rubber_suspension::test
