// Excerpts replace logs that are too long for the search.
#include "diagnosis/prepare/excerpts.h"

#include "gap/simulate.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/replay.h"
#include "shared_runs.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

using diagnosis::prepare::Excerpts;

constexpr std::int64_t kNanoseconds = 10000000;  // time step [ns]

// A sine of 1 Hz sampled at 100 Hz, which keeps each amplitude [mm] for `seconds`.
log::Log stairs(const std::vector<double>& amplitudes, double seconds) {
  const auto each = static_cast<std::size_t>(seconds * 100.0);
  return logOf(
      "stairs", static_cast<int>(each * amplitudes.size()), kNanoseconds,
      [&](int i) {
        return 1e-3 * amplitudes[static_cast<std::size_t>(i) / each] * std::sin(2.0 * element::kPi * 0.01 * i);
      },
      [](int /*i*/, double z) { return 1e6 * z; });
}

Excerpts makeExcerpts(const std::vector<log::Log>& logs, const std::vector<log::Log>& hold_out, std::size_t most) {
  const component::Component component({spring(1e6)});
  const auto surveys = [&](const std::vector<log::Log>& list) {
    std::vector<diagnosis::prepare::LogSurvey> result;
    for (const log::Log& log : list) {
      result.push_back(diagnosis::prepare::surveyLog(log::sourceOf(log), component));
    }
    return result;
  };
  return diagnosis::prepare::makeExcerpts(surveys(logs), surveys(hold_out), most);
}

std::size_t samplesOf(const std::vector<log::Log>& logs) {
  std::size_t sum = 0;
  for (const log::Log& log : logs) {
    sum += log.size();
  }
  return sum;
}

double largest(const log::Log& log) {
  return std::max(*std::max_element(log.displacement.begin(), log.displacement.end()),
                  -*std::min_element(log.displacement.begin(), log.displacement.end()));
}

TEST(Excerpts, LogsThatAreShortEnoughAreTakenAsTheyAre) {
  const std::vector<log::Log> logs = {stairs({1.0}, 60.0), stairs({2.0}, 30.0)};
  const Excerpts excerpts = makeExcerpts(logs, {}, 9000);
  ASSERT_EQ(excerpts.logs.size(), 2U);
  EXPECT_EQ(excerpts.logs[0].stamp, logs[0].stamp);
  EXPECT_EQ(excerpts.logs[0].notes, logs[0].notes);
  EXPECT_EQ(excerpts.logs[1].displacement, logs[1].displacement);
  EXPECT_EQ(excerpts.samples, 9000U);
  EXPECT_EQ(excerpts.of, 9000U);
}

TEST(Excerpts, HoldTheBeginningTheLargestMotionAndAllAmplitudes) {
  const std::vector<double> amplitudes = {1.0, 0.5, 2.0, 4.0, 0.25, 8.0, 1.5, 3.0, 0.5, 1.0, 6.0, 2.0};
  const log::Log log = stairs(amplitudes, 600.0);  // 720,000 samples
  const Excerpts excerpts = makeExcerpts({log}, {}, 80000);
  EXPECT_LE(excerpts.samples, 80000U);
  EXPECT_GT(excerpts.samples, 70000U);
  EXPECT_EQ(excerpts.of, log.size());
  EXPECT_EQ(excerpts.logs.front().stamp.front(), 0);
  EXPECT_EQ(excerpts.logs.front().name.substr(0, 11), "stairs (0 t");
  EXPECT_THAT(excerpts.logs.front().notes, testing::Contains("excerpt of 7200 s"));
  std::set<double> seen;
  std::int64_t last = -1;
  for (const log::Log& excerpt : excerpts.logs) {
    EXPECT_GT(excerpt.stamp.front(), last);  // in the order of recording, without overlap
    last = excerpt.stamp.back();
    EXPECT_EQ(excerpt.force.size(), excerpt.size());
    seen.insert(std::round(1e5 * largest(excerpt)) / 100.0);
  }
  EXPECT_TRUE(seen.count(8.0)) << "the largest motion";
  EXPECT_GE(seen.size(), 5U);
}

TEST(Excerpts, LeaveOutAStandstill) {
  const log::Log log = stairs({1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, 1000.0);
  for (const log::Log& excerpt : makeExcerpts({log}, {}, 80000).logs) {
    EXPECT_GT(largest(excerpt), 0.9e-3) << excerpt.name;
  }
}

TEST(Excerpts, WindowsHoldTenCyclesWhereTheyCan) {
  log::Log log = stairs({1.0}, 4000.0);
  for (std::int64_t& stamp : log.stamp) {
    stamp /= 100;  // Samples come a hundred times as fast. Windows have the same length in cycles, not in seconds.
  }
  for (const std::size_t most : {80000U, 8000U, 4000U, 1500U}) {
    for (const log::Log& excerpt : makeExcerpts({log}, {}, most).logs) {
      EXPECT_GE(excerpt.size(), 1000U) << most;
    }
  }
}

TEST(Excerpts, WhatShortLogsLeaveGoesToLongOnes) {
  const std::vector<log::Log> logs = {stairs({1.0}, 50.0), stairs({2.0}, 2000.0), stairs({2.0}, 2000.0)};
  const Excerpts excerpts = makeExcerpts(logs, {}, 65000);
  EXPECT_EQ(excerpts.logs.front().size(), 5000U);
  EXPECT_EQ(excerpts.logs.front().notes, logs.front().notes);
  EXPECT_NEAR(static_cast<double>(samplesOf(excerpts.logs)), 65000.0, 100.0);
}

TEST(Excerpts, AHoldOutGivesItsBeginning) {
  const log::Log log = stairs({1.0, 3.0}, 1000.0);
  const Excerpts excerpts = makeExcerpts({log}, {log}, 20000);
  ASSERT_EQ(excerpts.hold_out.size(), 1U);
  EXPECT_EQ(excerpts.hold_out.front().size(), 10000U);
  EXPECT_EQ(excerpts.hold_out.front().stamp.front(), 0);
}

// These elements remember the past longest: self-heating, softening by the largest displacement, slow relaxation.
TEST(Excerpts, AreLedInByWhatLiesBetweenThem) {
  const std::vector<element::ElementDescription> elements = {
      spring(1e6),
      maxwell(3e5, 0.01),
      {"stress_softening", {{"reduction", {0.3}}}},
      {"self_heating", {{"energy_sensitivity", {0.05}}, {"time_constant", {300.0}}}}};
  log::Log log = stairs({1.0, 2.0, 0.5, 1.5, 0.0, 1.0, 2.5, 0.8}, 100.0);
  log.force = gap::simulateLog(component::Component(elements), log);
  const double deviation = gap::standardDeviation(
      Eigen::Map<const Eigen::VectorXd>(log.force.data(), static_cast<Eigen::Index>(log.size())));
  const Excerpts excerpts = makeExcerpts({log}, {}, 20000);
  ASSERT_GT(excerpts.logs.size(), 2U);
  const auto worst = [&](const std::vector<gap::PreparedRecord>& records) {
    double gap = 0.0;
    const gap::Forces forces = gap::simulate(elements, records);
    for (std::size_t r = 0; r < records.size(); ++r) {
      gap = std::max(gap, gap::gapOfResidual(records[r].force - forces[r], deviation));
    }
    return gap;
  };
  std::vector<gap::PreparedRecord> rested;
  std::vector<gap::PreparedRecord> led_in;
  for (std::size_t i = 0; i < excerpts.logs.size(); ++i) {
    rested.emplace_back(log::evenRecord(excerpts.logs[i]));
    led_in.emplace_back(log::evenRecord(excerpts.logs[i], excerpts.lead_in[i]));
  }
  // The lead-in has means over 4 of the 100 samples of a cycle, which reduce the amplitude by 0.3 %. So a new largest
  // amplitude softens the rubber again in the excerpt: an error of 2.9 % of the force there, of 0.6 % elsewhere.
  EXPECT_LT(worst(led_in), 0.04);
  EXPECT_GT(worst(rested), 0.2) << "the test would not see it";
}

// The force takes a pause of 1e6 s as one time step, as in `replay` and the node. Spectra ignore the pause.
TEST(Excerpts, BeginAnewBehindATimeGap) {
  const std::vector<element::ElementDescription> elements = {
      spring(1e6), maxwell(3e5, 0.01), friction(300.0, 3e-4), {"stress_softening", {{"reduction", {0.3}}}}};
  log::Log log = stairs({1.0, 2.0, 0.5}, 20.0);
  for (std::size_t i = 0; i < log.size(); ++i) {
    log.stamp[i] += i < 2000 ? 0 : i < 4030 ? 70000000000 : 1000000000000000;  // two time gaps
  }
  log.force = gap::simulateLog(component::Component(elements), log);
  const Excerpts excerpts = makeExcerpts({log}, {}, log.size());
  ASSERT_EQ(excerpts.logs.size(), 3U);
  EXPECT_EQ(excerpts.samples, log.size());
  std::vector<gap::PreparedRecord> records;
  for (std::size_t i = 0; i < excerpts.logs.size(); ++i) {
    records.emplace_back(log::evenRecord(excerpts.logs[i], excerpts.lead_in[i]));
  }
  const gap::Forces forces = gap::simulate(elements, records);
  for (std::size_t r = 0; r < records.size(); ++r) {
    // Excerpts split some straight steps in two. This changes the forces by rounding only.
    EXPECT_LT((records[r].force - forces[r]).cwiseAbs().maxCoeff(), 1e-9 * 3e3) << r;
  }
}

TEST(Excerpts, LeaveOutStretchesBetweenTimeGapsThatAreTooShort) {
  log::Log log = stairs({1.0, 2.0}, 20.0);
  for (std::size_t i = 2000; i < log.size(); ++i) {
    log.stamp[i] += i < 2050 ? 70000000000 : 700000000000;
  }
  const Excerpts excerpts = makeExcerpts({log}, {log}, 2 * log.size());
  ASSERT_EQ(excerpts.logs.size(), 2U);
  EXPECT_EQ(excerpts.hold_out.size(), 2U);
  EXPECT_EQ(samplesOf(excerpts.logs), log.size() - 50);
  EXPECT_THAT(excerpts.logs.front().notes,
              testing::Contains(testing::HasSubstr("50 samples between the gaps are skipped")));
}

TEST(Excerpts, ALongLogIsDiagnosedByThem) {
  const diagnosis::Diagnosis& whole = ofOneLog();
  const log::Log log = runRigs({1}, nothing).front();
  EXPECT_EQ(whole.samples.searched, log.size());
  EXPECT_EQ(whole.samples.recorded, log.size());
  diagnosis::DiagnosisOptions options;
  options.most_samples = log.size() / 2;
  const diagnosis::Diagnosis part = diagnosis::diagnose(rigComponent(), {log}, {}, options);
  EXPECT_LE(part.samples.searched, options.most_samples);
  EXPECT_EQ(part.samples.recorded, log.size());
  EXPECT_EQ(part.answer.verdict, whole.answer.verdict);
  // Both runs state the gap of the whole log. Their parameters may differ within the noise.
  EXPECT_NEAR(part.gap_as_recorded.as_configured, whole.gap_as_recorded.as_configured, 1e-12);
}

}  // namespace
}  // namespace rubber_suspension
