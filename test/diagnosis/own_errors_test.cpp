// Errors of a single log are reported for this log and written to no file. No written file fits a log noticeably worse.
#include "diagnosis/results/own_errors.h"

#include "checked_diagnosis.h"
#include "diagnosis/results/left_of_logs.h"
#include "rig.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

using diagnosis::results::excessOf;
using diagnosis::results::leftOfLogs;
using diagnosis::results::unlikeMost;

TEST(OwnErrors, AreThoseOfLogsThatReadOtherwiseThanMost) {
  EXPECT_THAT(unlikeMost({0.001, 0.1, -0.002, 0.0}, 0.01), ElementsAre(false, true, false, false));
  EXPECT_THAT(unlikeMost({0.1, 0.0, 0.1, 0.0}, 0.01), ElementsAre(true, true, true, true)) << "no value is of most";
  EXPECT_THAT(unlikeMost({0.1, -0.05}, 0.01), ElementsAre(true, true));
  EXPECT_THAT(unlikeMost({0.001, 0.002, 0.003}, 0.01), ElementsAre(true, false, true)) << "all alike: about one";
}

// A gain of one log must not become a mean gain of all logs in the file.
TEST(OwnErrors, OfOneLogIsAFindingOfThatLog) {
  std::vector<log::Log> logs = runRigs({1, 2, 4}, nothing);
  for (double& force : logs[1].force) {
    force *= 1.1;
  }
  const diagnosis::Diagnosis result = checkedDiagnosis(rigComponent(), logs, {});
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::none) << result.sentence;
  EXPECT_TRUE(result.law.augmented.add.empty());
  EXPECT_THAT(result.sentence, HasSubstr("Log log 2 has forces 10 % higher than the other logs."));
  std::vector<std::string> with_gain;
  for (const measurement::RigFinding& finding : result.rig_findings) {
    if (finding.finding == measurement::finding::kSensorGain) {
      with_gain.push_back(finding.log);
      EXPECT_NEAR(finding.value, 0.1, 0.005);
      EXPECT_TRUE(finding.beyond_tolerance);
    }
  }
  EXPECT_THAT(with_gain, ElementsAre("log 2"));
  EXPECT_LT(result.gaps.unseen.as_configured, 0.03);
  EXPECT_GT(result.gaps.further_log, 0.03) << "of such a rig";
}

TEST(LeftOfLogs, IsWithoutAnOffsetAndTheRigsPart) {
  gap::PreparedRecord record;
  record.name = "one";
  record.dt = 0.01;
  const Eigen::ArrayXd time = Eigen::ArrayXd::LinSpaced(1000, 0.0, 9.99);
  const Eigen::VectorXd force = 1e3 * (2.0 * time).sin() * (time / 3.0).min(1.0).square();  // starts from rest
  record.displacement = record.raw_displacement = 1e-6 * force;
  record.force = 1.1 * force.array() + 50.0;
  record.force_deviation = gap::standardDeviation(record.force);
  const gap::Forces configured = {force};
  const gap::Forces worse = {0.9 * force};
  const auto with_gain = leftOfLogs({record}, {{0.1, 0.0}}, configured, worse);
  EXPECT_LT(with_gain.front().configured, 1e-3);
  EXPECT_NEAR(with_gain.front().written, 0.1, 2e-3);
  EXPECT_GT(excessOf(with_gain), 0.0);
  const auto without = leftOfLogs({record}, {{}}, worse, configured);
  EXPECT_NEAR(without.front().written, 0.1 / 1.1, 2e-3);
  EXPECT_EQ(excessOf(without), 0.0);
}

// A small increase of the residual of one log is accepted. A small increase over all logs together is not.
TEST(LeftOfLogs, CountTogether) {
  EXPECT_EQ(excessOf({{"a", 0.010, 0.011, 4e-5}, {"b", 0.02, 0.01, 4e-5}}), 0.0);
  EXPECT_GT(excessOf({{"a", 0.010, 0.011, 4e-5}}), 0.0);
  EXPECT_EQ(diagnosis::results::worstOf({{"a", 0.010, 0.011, 4e-5}}).log, "all logs");
  EXPECT_EQ(diagnosis::results::worstOf({{"a", 0.010, 0.02, 4e-5}, {"b", 0.02, 0.01, 4e-5}}).log, "a");
}

}  // namespace
}  // namespace rubber_suspension
