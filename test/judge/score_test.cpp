// The scores of evidence, and evidence that is refused.
#include "diagnosis/judge/score.h"

#include "diagnosis/judge/answer.h"
#include "diagnosis/judge/evidence_json.h"
#include "judge/made_evidence.h"
#include "judge/read_evidence.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

using diagnosis::judge::Evidence;
using diagnosis::judge::HypothesisEvidence;
using diagnosis::judge::JudgeNumbers;
using diagnosis::judge::ScoreTable;

TEST(ScoreTable, RefusesEvidenceWithoutLogs) {
  Evidence evidence = unexplained(3, 2, 0.1);
  evidence.logs.clear();
  EXPECT_THROW(scoreTable(evidence), std::invalid_argument);
  evidence = unexplained(3, 2, 0.1);
  evidence.hypotheses.back().sizes.clear();
  EXPECT_THROW(scoreTable(evidence), std::invalid_argument);
}

// A noise floor that a wrong model overestimated is lowered to the smallest residual.
TEST(ScoreTable, HasNoFloorAboveWhatAHypothesisLeaves) {
  Evidence evidence = unexplained(2, 2, 0.1);
  explain(evidence, 0, 0.015);
  explain(evidence, 1, 0.004);
  evidence.logs.front().floor = 0.02;
  const diagnosis::judge::ScoreTable table = scoreTable(evidence);
  EXPECT_DOUBLE_EQ(table.floor[0], 0.004 * 0.004);
  EXPECT_DOUBLE_EQ(table.floor[1], kFloor * kFloor);
  EXPECT_DOUBLE_EQ(table.left(Evidence::kFirstSingle, 0), 0.015 * 0.015 - 0.004 * 0.004);
}

// For a single log, the weights are computed by hand from the equations in score.h.
TEST(LogWeights, AreThoseOfTheEquations) {
  Evidence evidence = unexplained(1, 1, 0.1, 50);
  explain(evidence, 0, 0.02);
  evidence.hypotheses.back().beyond = 3;
  JudgeNumbers numbers;
  numbers.sharpness = 6.0;
  numbers.tails = 3.0;
  numbers.floor_known = 0.5;
  numbers.accepted = 0.01;
  numbers.form_error = 0.1;
  numbers.share = 0.5;  // smaller than the share of the effect
  numbers.per_number_beyond = 0.4;
  numbers.rest = -2.0;
  numbers.effect = -3.0;
  const diagnosis::judge::LogWeights weights = logWeights(scoreTable(evidence), numbers);
  const double r2 = 0.02 * 0.02 - kFloor * kFloor;
  const double s2 = std::pow(0.5 * kFloor, 2) + 0.01 * 0.01 + 0.1 * 0.1 * (0.1 * 0.1 - 0.02 * 0.02);
  const double prior = -3.0 - 0.4 * 3.0 * 0.5 * std::log(50.0);
  EXPECT_NEAR(weights.alone[Evidence::kFirstSingle], -3.0 * (std::log(s2) + 4.0 * std::log1p(r2 / (3.0 * s2))) + prior,
              1e-9);
  EXPECT_NEAR(weights.beside[Evidence::kFirstSingle], -3.0 * (std::log(std::max(r2, s2)) + 1.0) - 2.0 + prior, 1e-9);

  // A law with only one form has a smaller form error.
  Evidence of_one_form = evidence;
  of_one_form.one_form = {true};
  numbers.form_error_of_one = 0.02;
  EXPECT_NEAR(expectedSquares(scoreTable(of_one_form), numbers)(Evidence::kFirstSingle, 0),
              std::pow(0.5 * kFloor, 2) + 0.01 * 0.01 + 0.02 * 0.02 * (0.1 * 0.1 - 0.02 * 0.02), 1e-12);

  // The second octave has a quarter of the log's force and all of the residual.
  evidence.logs.front().octaves = {0.75, 0.25};
  evidence.hypotheses.back().shares = {{0.0, 1.0}};
  const double in_octaves = 0.75 * std::log(s2) + 0.25 * std::log(std::max(r2 / 0.25, s2)) + 1.0;
  EXPECT_NEAR(logWeights(scoreTable(evidence), numbers).beside[Evidence::kFirstSingle], -3.0 * in_octaves - 2.0 + prior,
              1e-9);
}

// The cost of a departure from the data sheet is that of Student's t. A small effect has a cost by its share.
TEST(LogWeights, CostDeparturesFromTheSheetAndSmallShares) {
  Evidence evidence = unexplained(1, 1, 0.1, 50);
  explain(evidence, 0, 0.02);
  JudgeNumbers numbers;
  numbers.sheet_scale = 2.0;
  numbers.sheet_tails = 3.0;
  numbers.accepted = 0.01;
  const auto alone = [&] { return logWeights(scoreTable(evidence), numbers).alone[Evidence::kFirstSingle]; };
  const double at_once = alone();
  evidence.hypotheses.back().chi_squared = 12.0;
  EXPECT_NEAR(alone(), at_once - 0.5 * 4.0 * std::log1p(12.0 / 4.0 / 3.0), 1e-9);
  evidence.hypotheses.back().chi_squared = 0.0;
  numbers.form_error = 1e-9;  // so that the size changes nothing else
  const double large = alone();
  evidence.hypotheses.back().sizes.front().front() = 0.01 * 0.01;
  const double usual = numbers.share * std::sqrt(0.1 * 0.1 - kFloor * kFloor + 0.01 * 0.01);
  EXPECT_NEAR(alone(), large - 0.5 * std::pow(std::log(0.01 / usual) / numbers.share_spread, 2), 1e-6);
}

// The values of a guess are never confirmed, whatever their residual. The verdict is a parameter error instead.
TEST(LogWeights, NeverTakeAGuessAsConfigured) {
  Evidence evidence = unexplained(2, 1, 0.004);
  evidence.hypotheses.front().log_errors = evidence.hypotheses[Evidence::kReEstimated].log_errors;
  EXPECT_EQ(diagnosis::judge::answer(evidence).verdict, diagnosis::Verdict::none);
  evidence.guess = true;
  EXPECT_EQ(diagnosis::judge::answer(evidence).verdict, diagnosis::Verdict::parameter_error);
}

// A file of evidence contains all inputs of the judgement, including infinite residuals.
TEST(EvidenceJson, IsReadAsItWasWritten) {
  Evidence evidence = unexplained(3, 2, 0.1);
  explain(evidence, 1, 0.01);
  evidence.logs.back().unseen = true;
  evidence.logs.front().octaves = {0.25, 0.75};
  evidence.hypotheses.back().free_in_log.gain = true;
  evidence.excluded = {false, true};
  evidence.hypotheses.back().beyond = 2;
  evidence.hypotheses.back().shares = {{0.5, 0.5}, {1.0}, {1.0}};
  evidence.hypotheses[2].log_errors[1] = std::numeric_limits<double>::infinity();
  const Evidence read = diagnosis::parseEvidence(toJson(evidence));
  EXPECT_EQ(toJson(read), toJson(evidence));
  EXPECT_TRUE(std::isinf(read.hypotheses[2].log_errors[1]));
  EXPECT_EQ(diagnosis::judge::answer(read).candidates, diagnosis::judge::answer(evidence).candidates);
  for (const char* text : {"", "{}", "[]", R"({"schema": "rubber_suspension/evidence/2"})"}) {
    EXPECT_THROW(diagnosis::parseEvidence(text), std::invalid_argument) << text;
  }
}

// Logs cannot distinguish a gain of 6 % in all logs from values that are all off by 6 %, so both are reported. No gain
// is reported if values are off by different factors, or if a gain does not explain the residual.
TEST(Answer, TellsAGainOfAllLogsBesideWrongValues) {
  Evidence evidence = unexplained(2, 1, kFloor);
  const std::vector<double> gap(2, 0.06 * 0.06);
  const auto leave = [&](double values, double gain) {
    evidence.hypotheses = {fitted({}, gap, {}), fitted({}, std::vector<double>(2, values * values), {}),
                           fitted({0}, std::vector<double>(2, gain * gain), {gap})};
    evidence.hypotheses.back().keeps_values = true;
    return diagnosis::judge::answer(evidence);
  };
  const diagnosis::judge::Answer either = leave(kFloor, kFloor);
  EXPECT_EQ(either.verdict, diagnosis::Verdict::parameter_error);
  ASSERT_EQ(either.alternatives.size(), 1);
  EXPECT_EQ(either.alternatives.front().effects, std::vector<int>{0});
  EXPECT_TRUE(leave(kFloor, 0.03).alternatives.empty());
  EXPECT_EQ(leave(0.05, 0.05).verdict, diagnosis::Verdict::unknown);
}

// A law that contains another is named only if it reduces the residual of that other law as much as an effect does.
TEST(Answer, NamesALawThatContainsAnotherForWhatItRemovesBeyond) {
  Evidence evidence = unexplained(3, 2, 0.1);
  evidence.effects = {"friction", "backlash"};
  evidence.contains[1] = {0};
  const auto leave = [&](double friction, double backlash) {
    explain(evidence, 0, friction);
    explain(evidence, 1, backlash);
    evidence.hypotheses.back().beyond = 1;
    return diagnosis::judge::answer(evidence);
  };
  const diagnosis::judge::Answer alike = leave(0.0101, 0.01);
  EXPECT_EQ(alike.effects, std::vector<int>{0});
  const double of_larger = alike.candidates[1];
  EXPECT_EQ(leave(0.06, 0.01).effects, std::vector<int>{1});

  evidence.effects = {"friction", "relaxation"};
  evidence.contains[1].clear();  // neither effect contains the other
  EXPECT_GT(leave(0.0101, 0.01).candidates[1], 5.0 * of_larger) << of_larger;
}

// An excluded effect has no probability, however well it explains the logs. Its share goes to the other effects, and to
// a residual force without a listed cause.
TEST(Answer, NamesNothingThatIsExcluded) {
  Evidence evidence = unexplained(3, 2, 0.1);
  explain(evidence, 0, kFloor);
  explain(evidence, 1, 0.02);
  EXPECT_EQ(diagnosis::judge::answer(evidence).effects, std::vector<int>{0});
  evidence.excluded = {true, false};
  const diagnosis::judge::Answer without = diagnosis::judge::answer(evidence);
  EXPECT_EQ(without.effects, std::vector<int>{1});
  EXPECT_EQ(without.candidates[0], 0.0);
  evidence.excluded = {true, true};
  EXPECT_EQ(diagnosis::judge::answer(evidence).verdict, diagnosis::Verdict::unknown);
}

// The effect moves a value far from the data sheet and has most of the force, such as friction in place of a dashpot. A
// residual force without a listed cause is more probable. An effect that halves the residual is reported beside it, and
// three effects that do so equally are reported as confounded.
TEST(Answer, TellsAnEffectThatHalvesTheRestBesideIt) {
  Evidence evidence = unexplained(1, 3, 0.25, 8);
  const double before = 0.25 * 0.25;
  const auto leave = [&](std::size_t effect, double square) {
    HypothesisEvidence& single = evidence.hypotheses[Evidence::kFirstSingle + effect];
    single = fitted({static_cast<int>(effect)}, {square}, {{0.8}});
    single.chi_squared = 60.0;
  };
  leave(0, 0.51 * before);
  const diagnosis::judge::Answer unknown = diagnosis::judge::answer(evidence);
  EXPECT_EQ(unknown.verdict, diagnosis::Verdict::unknown);
  EXPECT_GT(unknown.posterior.none_of_these, 0.5);

  leave(0, 0.2 * before);
  const ScoreTable table = scoreTable(evidence);
  EXPECT_GT(setPosterior(table, diagnosis::judge::fittedNumbers()).unknown, 0.5);
  const diagnosis::judge::Answer partly = diagnosis::judge::answer(table);
  EXPECT_EQ(partly.verdict, diagnosis::Verdict::partly);
  EXPECT_EQ(partly.effects, std::vector<int>{0});
  EXPECT_EQ(partly.posterior.none_of_these, 0.0);

  leave(1, 0.2 * before);
  leave(2, 0.2 * before);
  const diagnosis::judge::Answer either = diagnosis::judge::answer(evidence);
  EXPECT_EQ(either.verdict, diagnosis::Verdict::confounded);
  EXPECT_THAT(either.confounded,
              testing::UnorderedElementsAre(std::vector<int>{0}, std::vector<int>{1}, std::vector<int>{2}));

  evidence.excluded = {true, true, true};
  EXPECT_EQ(diagnosis::judge::answer(evidence).verdict, diagnosis::Verdict::unknown);
}

// Held-out logs count as logs, so a law that fails on them is not the answer.
TEST(LogWeights, CountUnseenLogs) {
  Evidence evidence = unexplained(4, 1, 0.1);
  explain(evidence, 0, 0.004);
  const JudgeNumbers numbers;
  const double before = logWeights(scoreTable(evidence), numbers).alone[Evidence::kFirstSingle];
  evidence.logs.back().unseen = true;
  evidence.hypotheses.back().log_errors.back() = 0.1 * 0.1;
  EXPECT_LT(logWeights(scoreTable(evidence), numbers).alone[Evidence::kFirstSingle], before - 1.0);
}

TEST(JudgeNumbers, AreEachInTheTableOnce) {
  JudgeNumbers numbers;
  for (const diagnosis::judge::NumberInfo& info : diagnosis::judge::numberTable()) {
    EXPECT_EQ(numbers.*info.value, info.mean) << info.name;  // default value before any fit
    numbers.*info.value = -1e9;
  }
  for (const diagnosis::judge::NumberInfo& info : diagnosis::judge::numberTable()) {
    EXPECT_EQ(numbers.*info.value, -1e9) << info.name;
    EXPECT_TRUE(std::isfinite(diagnosis::judge::fittedNumbers().*info.value)) << info.name;
  }
}

}  // namespace
}  // namespace rubber_suspension::test
