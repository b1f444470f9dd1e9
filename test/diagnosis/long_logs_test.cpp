// The summary that the diagnosis keeps of a log that is too long for the memory.
#include "diagnosis/prepare/lead_in.h"
#include "diagnosis/prepare/log_survey.h"
#include "diagnosis/results/replayed.h"
#include "gap/simulate.h"
#include "log/samples.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

using diagnosis::prepare::LeadInBuilder;
using diagnosis::prepare::LogSurvey;
using diagnosis::prepare::MotionSurvey;
using diagnosis::results::Recorded;

const std::vector<element::ElementDescription> kElements = {
    spring(1e6), friction(50.0, 1e-4), {"stress_softening", {{"reduction", {0.3}}}}};

double deviationOf(const std::vector<double>& z, std::size_t first, std::size_t last) {
  const auto begin = z.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = z.begin() + static_cast<std::ptrdiff_t>(last);
  const auto count = static_cast<double>(last - first);
  const double mean = std::accumulate(begin, end, 0.0) / count;
  const double squares =
      std::accumulate(begin, end, 0.0, [&](double sum, double value) { return sum + std::pow(value - mean, 2); });
  return std::sqrt(squares / count);
}

// Returns a sine of 1 mm about a mean of 0.5 m, with one cycle of twice the amplitude.
std::vector<double> motion(std::size_t samples, double per_cycle) {
  std::vector<double> z(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const double cycles = static_cast<double>(i) / per_cycle;
    z[i] = 0.5 - 1e-3 * (std::floor(cycles) == 17.0 ? 2.0 : 1.0) * std::sin(2.0 * element::kPi * cycles);
  }
  return z;
}

TEST(MotionSurvey, KnowsALongMotionByItsStretches) {
  constexpr std::size_t kSamples = 300007;
  for (const double per_cycle : {5000.0, 100.0}) {
    const std::vector<double> z = motion(kSamples, per_cycle);
    MotionSurvey survey;
    for (std::size_t first = 0; first < kSamples; first += 1000) {
      survey.add({z.begin() + static_cast<std::ptrdiff_t>(first),
                  z.begin() + static_cast<std::ptrdiff_t>(std::min(first + 1000, kSamples))});
    }
    EXPECT_EQ(survey.samples(), kSamples);
    EXPECT_EQ(survey.stretch(), 8U);  // the smallest power of two with at most 65,536 stretches
    // The mean is 500 times the amplitude, so deviations from sums of squares lose at most 6 of 16 digits.
    EXPECT_NEAR(survey.deviation(0, kSamples), deviationOf(z, 0, kSamples), 1e-12);
    EXPECT_NEAR(survey.deviation(8000, 16000), deviationOf(z, 8000, 16000), 1e-12);
    const auto largest = static_cast<std::size_t>(std::max_element(z.begin(), z.end()) - z.begin());
    EXPECT_EQ(survey.largest(), largest / 8 * 8);
    // Each cycle crosses the mean twice. The count of crossings may be off by one.
    EXPECT_NEAR(survey.samplesPerCycle(), per_cycle, per_cycle * per_cycle / static_cast<double>(kSamples));
  }
}

TEST(MotionSurvey, KeepsShortMotionsSampleBySample) {
  const std::vector<double> z = motion(20000, 7.0);
  MotionSurvey survey;
  survey.add(z);
  EXPECT_EQ(survey.stretch(), 1U);
  EXPECT_NEAR(survey.samplesPerCycle(), 7.0, 7.0 * 7.0 / 20000.0);
}

log::LeadIn leadIn(std::size_t samples, double per_cycle, std::size_t coarse, double standstill = 0.0) {
  LeadInBuilder builder(10, 10 + samples, coarse, standstill, 1000000000);
  const std::vector<double> z = motion(samples + 20, per_cycle);
  for (std::size_t i = 0; i < z.size(); ++i) {
    builder.add(i, static_cast<std::int64_t>(i) * 1000000, z[i]);
  }
  return builder.finish();
}

double amplitudeOf(const log::LeadIn& lead_in) {
  const auto [low, high] = std::minmax_element(lead_in.displacement.begin(), lead_in.displacement.end());
  return 0.5 * (*high - *low);
}

TEST(LeadIn, IsMeansWhereTheseHoldTheMotion) {
  const log::LeadIn of_means = leadIn(10005, 1000.0, 10);
  EXPECT_EQ(of_means.displacement.size(), 1000U);
  EXPECT_NEAR(of_means.dt, 0.01, 1e-12);
  const std::vector<double> z = motion(10025, 1000.0);
  for (std::size_t i = 0; i < 1000; ++i) {
    const auto begin = z.begin() + static_cast<std::ptrdiff_t>(15 + 10 * i);  // the first 5 are no full step
    ASSERT_NEAR(of_means.displacement[i], std::accumulate(begin, begin + 10, 0.0) / 10.0, 1e-12);
  }
}

// With 20 samples per cycle, means of 16 samples are close to zero.
TEST(LeadIn, KeepsAmplitudesWhereMeansLoseThem) {
  for (const std::size_t samples : {3200U, 3216U}) {  // an even and an odd number of steps
    const log::LeadIn lead_in = leadIn(samples, 20.0, 16);
    EXPECT_EQ(lead_in.displacement.size(), samples / 16);
    EXPECT_NEAR(amplitudeOf(lead_in), 2e-3, 2e-3 * (1.0 - std::cos(element::kPi / 20.0)));
    std::size_t swings = 0;
    for (std::size_t i = 1; i < lead_in.displacement.size(); ++i) {
      swings += std::abs(lead_in.displacement[i] - lead_in.displacement[i - 1]) > 1.9e-3 ? 1 : 0;
    }
    EXPECT_GE(swings, samples / 32) << "one in each pair of steps";
  }
}

TEST(LeadIn, OfAStandstillIsTheMean) {
  EXPECT_LT(amplitudeOf(leadIn(3200, 20.0, 16, 0.01)), 1e-3);
  EXPECT_GT(amplitudeOf(leadIn(3200, 20.0, 16, 1e-4)), 1e-3);
}

log::Log recording(int samples, double amplitude) {
  const auto phase = [](int i) { return 2.0 * element::kPi * i / 200.0; };
  return logOf(
      "recording", samples, 1000000, [&](int i) { return amplitude * std::sin(phase(i)); },
      [&](int i, double z) { return 1.1e6 * z + 5.0 * std::cos(phase(i)); });
}

std::vector<LogSurvey> surveysOf(const std::vector<log::Log>& logs) {
  const component::Component component(kElements);
  std::vector<LogSurvey> surveys;
  for (const log::Log& log : logs) {
    surveys.push_back(diagnosis::prepare::surveyLog(log::sourceOf(log), component));
  }
  return surveys;
}

TEST(RecordedGap, IsThatOfTheLogsInMemory) {
  const std::vector<log::Log> logs = {recording(log::kLogBlock + 777, 2e-3), recording(3000, 1e-3)};
  std::vector<gap::PreparedRecord> records;
  for (const log::Log& log : logs) {
    records.push_back(log::evenRecord(log));
  }
  const std::vector<element::ElementDescription> spring = {kElements.front()};
  const auto expected = [&](const std::vector<element::ElementDescription>& elements, Recorded recorded) {
    return gap::gapOfParts(gap::partErrors(records, recorded == Recorded::on_one_component
                                                        ? gap::simulate(elements, records)
                                                        : gap::simulateEach(elements, records)));
  };
  std::vector<double> of_both;
  for (const Recorded recorded : {Recorded::on_one_component, Recorded::each_on_a_new_one}) {
    const std::vector<double> gaps =
        diagnosis::results::recordedGaps({kElements, spring}, surveysOf(logs), recorded, 2);
    ASSERT_EQ(gaps.size(), 2U);
    EXPECT_NEAR(gaps[0], expected(kElements, recorded), 1e-9 * gaps[0]);
    EXPECT_NEAR(gaps[1], expected(spring, recorded), 1e-9 * gaps[1]);
    of_both.push_back(gaps[0]);
  }
  EXPECT_GT(std::abs(of_both[0] - of_both[1]), 1e-4) << "softening of the first log would not show";
}

TEST(LogSurvey, FindsThatALogWasShortenedMeanwhile) {
  log::Log log = recording(1000, 1e-3);
  const std::vector<LogSurvey> surveys = surveysOf({log});
  std::size_t read = 0;
  const auto count = [&](const log::Log& block, std::size_t) {
    read += block.size();
    return true;
  };
  LogSurvey survey = surveys.front();
  survey.source = log::sourceOf(recording(1500, 1e-3));  // the log is still being written
  diagnosis::prepare::readAgain(survey, count);
  EXPECT_EQ(read, 1000U);
  survey.source = log::sourceOf(recording(900, 1e-3));
  EXPECT_THROW(diagnosis::prepare::readAgain(survey, count), log::LogError);
}

}  // namespace
}  // namespace rubber_suspension
