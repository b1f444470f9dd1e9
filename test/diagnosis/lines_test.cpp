// Spectral lines of mains and pumps in the force of all logs, and signals that may be mistaken for such lines.
#include "diagnosis/prepare/lines.h"

#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/results/taken_out.h"
#include "diagnosis/rig.h"
#include "rubber_suspension/measurement/prepared_log.h"

namespace rubber_suspension {
namespace {

using diagnosis::prepare::RigLines;

// Returns an oscillation [N] whose phase is a random walk with a standard deviation of 0.3 rad after 1 s.
RigEffect line(double frequency, double amplitude) {
  return [=, generator = std::mt19937(7), phase = 0.0, before = 0.0](double time, double, double) mutable {
    phase += std::normal_distribution<double>(0.0, 0.3 * std::sqrt(std::max(time - before, 0.0)))(generator);
    before = time;
    return amplitude * std::sin(2.0 * element::kPi * frequency * time + phase);
  };
}

RigEffect both(RigEffect a, RigEffect b) {
  return [a = std::move(a), b = std::move(b)](double time, double z, double rate) mutable {
    return a(time, z, rate) + b(time, z, rate);
  };
}

RigLines linesOf(const std::vector<log::Log>& logs) {
  std::vector<log::Record> records;
  for (const log::Log& log : logs) {
    records.push_back(measurement::prepareLog(log).record);
  }
  return diagnosis::prepare::linesOfRig(
      records, gap::simulateEach(rigComponent().allElements(), {records.begin(), records.end()}));
}

// Records 20 s of a sine of a frequency [Hz] at three amplitudes, one log for each.
std::vector<log::Log> sines(double frequency, const RigEffect& effect) {
  std::vector<log::Log> logs;
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937 generator(seed);
    const double omega = 2.0 * element::kPi * frequency;
    const double amplitude = 4e-4 * seed;
    logs.push_back(runMotion(
        "sine " + std::to_string(seed), generator,
        [=](double time) {
          return std::make_pair(amplitude * std::sin(omega * time), amplitude * omega * std::cos(omega * time));
        },
        effect, 5.0, 0.004));
  }
  return logs;
}

TEST(Lines, AreFoundWithFrequencyAmplitudeAndPhase) {
  RigEffect same = line(50.0, 60.0);
  const RigEffect mains = same;
  const RigLines lines = linesOf(runRigs({1, 2, 4}, mains));
  ASSERT_THAT(lines.findings, SizeIs(3));
  for (const measurement::RigFinding& finding : lines.findings) {
    EXPECT_EQ(finding.finding, "line");
    EXPECT_EQ(finding.unit, "N");
    EXPECT_NEAR(finding.frequency, 50.0, 0.05);
    EXPECT_NEAR(finding.value, 60.0, 2.0);
    EXPECT_LT(finding.interval_95[0], finding.value);
    EXPECT_LT(finding.interval_95[1], 65.0);
    EXPECT_EQ(finding.text.substr(0, 9), "50.0 Hz, ");
    EXPECT_THAT(finding.text, HasSubstr(" N: mains or a pump"));
  }
  double left = 0.0;
  for (Eigen::Index i = 0; i < lines.forces[0].size(); ++i) {
    left += std::pow(lines.forces[0][i] - same(0.004 * static_cast<double>(i), 0.0, 0.0), 2);
  }
  EXPECT_LT(std::sqrt(left / static_cast<double>(lines.forces[0].size())), 8.0);  // the line has an RMS of 42 N
}

TEST(Lines, AreNamedAsHarmonicsAndAliases) {
  // Sampling at 250 Hz shows a line of 180 Hz at 70 Hz.
  const RigLines lines = linesOf(runRigs({1, 2}, both(both(line(31.0, 60.0), line(62.0, 50.0)), line(180.0, 70.0))));
  ASSERT_THAT(lines.findings, SizeIs(6));
  EXPECT_THAT(lines.findings[0].text, HasSubstr("31.0 Hz, "));
  EXPECT_THAT(lines.findings[1].text, HasSubstr("mains or a pump, harmonic 2 of 31.0 Hz"));
  EXPECT_THAT(lines.findings[2].text, HasSubstr("perhaps an alias of 180 Hz at 250 samples per second"));
}

TEST(Lines, AreInAllLogs) {
  std::vector<log::Log> logs = runRigs({1, 2}, line(50.0, 60.0));
  EXPECT_THAT(linesOf(logs).findings, SizeIs(2));
  logs.push_back(runRig("without", 4, nothing));
  EXPECT_THAT(linesOf(logs).findings, SizeIs(0));
}

// Friction produces harmonics of a sine and their aliases. They are as steady as the lines of mains and pumps.
TEST(Lines, AreNoMultiplesOfTheMotion) {
  for (const double frequency : {1.0, 2.3, 5.0, 8.7, 16.7}) {
    EXPECT_THAT(linesOf(sines(frequency, rigFriction())).findings, SizeIs(0)) << frequency;
  }
  const RigLines beside = linesOf(sines(5.0, both(rigFriction(), line(48.3, 40.0))));
  ASSERT_THAT(beside.findings, SizeIs(3));
  EXPECT_NEAR(beside.findings[0].frequency, 48.3, 0.1);
}

// A resonance of high quality excited by noise is as narrow as a line of mains or pumps, but its amplitude varies.
TEST(Lines, AreSteady) {
  const double omega = 2.0 * element::kPi * 30.0 * 0.004;
  const double decay = std::exp(-omega / 200.0);
  const auto mode = [=, generator = std::mt19937(3), x = 0.0, before = 0.0](double, double, double) mutable {
    const double next = 2.0 * decay * std::cos(omega) * x - decay * decay * before +
                        std::normal_distribution<double>(0.0, 5.0)(generator);
    before = x;
    return x = next;
  };
  EXPECT_THAT(linesOf(runRigs({1, 2, 4}, mode)).findings, SizeIs(0));
}

TEST(Lines, AreNoneInASlowLog) {
  std::mt19937 generator(1);
  const auto motion = [](double time) {
    return std::make_pair(1e-3 * std::sin(0.01 * time), 1e-5 * std::cos(0.01 * time));
  };
  EXPECT_THAT(linesOf({runMotion("slow", generator, motion, nothing, 20.0, 5.0)}).findings, SizeIs(0));
}

TEST(Lines, AreRemovedBeforeALogIsJudged) {
  const RigEffect mains = line(50.0, 120.0);
  const diagnosis::Diagnosis result = checkedDiagnosis(rigComponent(), runRigs({1, 2, 4}, mains), runRigs({3}, mains));
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::none) << result.sentence;
  EXPECT_THAT(result.sentence, HasSubstr("A spectral line that the motion does not cause is removed: 50.0 Hz, "));
  const auto lines = std::count_if(result.rig_findings.begin(), result.rig_findings.end(),
                                   [](const auto& finding) { return finding.finding == "line"; });
  EXPECT_EQ(lines, 4);
  const auto share = std::find_if(result.logs.taken_out.begin(), result.logs.taken_out.end(),
                                  [](const auto& part) { return part.kind == diagnosis::results::taken_out::kLine; });
  ASSERT_NE(share, result.logs.taken_out.end());
  EXPECT_NEAR(share->share, 120.0 / std::sqrt(2.0) / result.workings->simulated.records[0].force_deviation, 0.01);
  EXPECT_GT(result.gap_as_recorded.as_configured, 2.0 * result.gaps.unseen.as_configured);
}

}  // namespace
}  // namespace rubber_suspension
