// The live gap: comparison with a known size, location, thresholds, trend.
#include "node/live_gap.h"

#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr double kStep = 1e-3;       // [s]
constexpr double kStiffness = 3e6;   // [N/m]
constexpr double kAmplitude = 2e-3;  // [m]
constexpr double kOmega = 2.0 * element::kPi * 4.0;
constexpr double kRms = kStiffness * kAmplitude / M_SQRT2;  // RMS of the simulated force [N]

// Returns samples of a sine of 4 Hz, 10 s by default. `error` is the error of the force as a function of time.
std::vector<node::MatchedSample> samples(const std::function<double(double)>& error, int count = 10000) {
  std::vector<node::MatchedSample> result;
  for (int i = 0; i < count; ++i) {
    const double time = kStep * i;
    const double displacement = kAmplitude * std::sin(kOmega * time);
    const double force = kStiffness * displacement;
    result.push_back({static_cast<std::int64_t>(i) * 1000000, displacement, force, force + error(time)});
  }
  return result;
}

double share(const node::LiveGap& gap, gap::Quantity quantity) { return gap.share[static_cast<std::size_t>(quantity)]; }

TEST(LiveGap, IsNotKnownWithoutSamples) {
  const node::LiveGap gap = node::measureGap({}, node::GapSettings());
  EXPECT_FALSE(gap.known);
  EXPECT_FALSE(gap.reason.empty());
  EXPECT_EQ(gap.level(node::GapSettings()), node::GapLevel::unknown);
}

TEST(LiveGap, IsNotKnownWhereNothingMoves) {
  std::vector<node::MatchedSample> still;
  for (int i = 0; i < 10000; ++i) {
    still.push_back({static_cast<std::int64_t>(i) * 1000000, 1e-3, 3000.0, 3000.0});
  }
  EXPECT_FALSE(node::measureGap(still, node::GapSettings()).known);
}

TEST(LiveGap, AStiffnessThatIsOffIsInPhase) {
  // The force is 10 % too large, so the gap relative to the measured standard deviation is 0.1/1.1.
  const node::LiveGap gap = node::measureGap(
      samples([](double t) { return 0.1 * kStiffness * kAmplitude * std::sin(kOmega * t); }), node::GapSettings());
  ASSERT_TRUE(gap.known) << gap.reason;
  EXPECT_NEAR(gap.gap, 0.1 / 1.1, 1e-6);
  EXPECT_GT(share(gap, gap::Quantity::stiffness), 0.98);
  EXPECT_EQ(gap.cells.front().quantity, gap::Quantity::stiffness);
  EXPECT_LE(gap.cells.front().frequency[0], 4.0);
  EXPECT_GE(gap.cells.front().frequency[1], 4.0);
  EXPECT_LE(gap.cells.front().amplitude[0], kAmplitude);
  EXPECT_GE(gap.cells.front().amplitude[1], kAmplitude);
}

TEST(LiveGap, ALossThatIsOffIsInQuadrature) {
  const node::LiveGap gap = node::measureGap(
      samples([](double t) { return 0.1 * kStiffness * kAmplitude * std::cos(kOmega * t); }), node::GapSettings());
  ASSERT_TRUE(gap.known);
  EXPECT_GT(share(gap, gap::Quantity::loss), 0.98);
  EXPECT_GT(gap.iso18571.total, 0.8);
  EXPECT_LT(gap.iso18571.total, 1.0);
  EXPECT_TRUE(gap.iso18571.repeats) << "a sine";
}

TEST(LiveGap, HarmonicsMeanAndDriftAreToldApart) {
  const node::LiveGap harmonics =
      node::measureGap(samples([](double t) { return 0.1 * kStiffness * kAmplitude * std::sin(3.0 * kOmega * t); }),
                       node::GapSettings());
  EXPECT_GT(share(harmonics, gap::Quantity::harmonics), 0.98);
  // The offset exceeds twice the tolerance of 10 % of the range (2400 N).
  const node::LiveGap mean = node::measureGap(samples([](double) { return 5000.0; }), node::GapSettings());
  EXPECT_GT(share(mean, gap::Quantity::mean), 0.98);
  EXPECT_NEAR(mean.gap, 5000.0 / kRms, 1e-6);
  const node::LiveGap drift =
      node::measureGap(samples([](double t) { return 100.0 * (t - 5.0); }), node::GapSettings());
  // The gap is computed in 5 windows of 2 s. In each, the drift counts partly as harmonics, at most 1/25 of it.
  EXPECT_GT(share(drift, gap::Quantity::drift), 0.9);
}

TEST(LiveGap, SharesAddUpToOne) {
  const node::LiveGap gap = node::measureGap(
      samples([](double t) { return 300.0 * std::sin(kOmega * t + 1.0) + 100.0 + 20.0 * t; }), node::GapSettings());
  double sum = 0.0;
  for (const double part : gap.share) {
    sum += part;
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

TEST(LiveGap, NoiseIsNoGap) {
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, 0.15 * kRms);
  const node::LiveGap gap = node::measureGap(samples([&](double) { return noise(random); }), node::GapSettings());
  ASSERT_TRUE(gap.known);
  // The noise floor is estimated from the upper part of the spectrum, with an error of some per cent.
  EXPECT_NEAR(gap.noise_floor, gap.gap, 0.1 * gap.gap);
  EXPECT_GT(gap.gap, 0.1);
  EXPECT_LT(gap.beyond_noise, 0.1);
  EXPECT_EQ(gap.level(node::GapSettings()), node::GapLevel::ok);
}

bool finds(const node::LiveGap& gap, const std::string& name) {
  return std::any_of(gap.rig_findings.begin(), gap.rig_findings.end(),
                     [&](const measurement::RigFinding& finding) { return finding.finding == name; });
}

TEST(LiveGap, WhatTheRigDoesWithinItsTolerancesIsNone) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.01 * kRms);
  // The rig adds an offset of 500 N and a delay of half a sample. The delay adds 1.3 % of the force in quadrature.
  const auto rig = [&](double time) {
    const double late = kStiffness * kAmplitude * (std::sin(kOmega * (time - 0.5 * kStep)) - std::sin(kOmega * time));
    return 500.0 + late + noise(random);
  };
  const node::LiveGap gap = node::measureGap(samples(rig), node::GapSettings());
  ASSERT_TRUE(gap.known) << gap.reason;
  EXPECT_NEAR(gap.gap, 0.01, 0.0005);  // 10 000 samples of noise
  EXPECT_NEAR(gap.gap_as_recorded, 500.0 / kRms, 0.01);
  EXPECT_TRUE(finds(gap, measurement::finding::kForceZero));
  EXPECT_TRUE(finds(gap, measurement::finding::kDelay));
}

TEST(LiveGap, ToleranceIsThatOfTheRig) {
  io::RigTolerances strict;
  strict.force_zero = {100.0, false};
  const auto zero = [](double) { return 500.0; };
  const node::LiveGap gap = node::measureGap(samples(zero), node::GapSettings(), strict);
  EXPECT_NEAR(gap.gap, 500.0 / kRms, 1e-3);
  EXPECT_GT(share(gap, gap::Quantity::mean), 0.98);
  EXPECT_TRUE(finds(gap, measurement::finding::kForceZero));  // the finding is reported nevertheless
}

TEST(LiveGap, SpikesDoNotCount) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.01 * kRms);
  const auto spiky = [&](double time) {
    const auto sample = static_cast<int>(std::lround(time / kStep));
    return noise(random) + (sample % 2500 == 1234 ? 3.0 * kRms : 0.0);
  };
  const node::LiveGap gap = node::measureGap(samples(spiky), node::GapSettings());
  ASSERT_TRUE(gap.known) << gap.reason;
  EXPECT_NEAR(gap.gap, 0.01, 0.0005);
  EXPECT_TRUE(finds(gap, measurement::finding::kSpikes));
}

TEST(LiveGap, ThresholdsActOnWhatIsBeyondNoise) {
  node::LiveGap gap;
  gap.known = true;
  const node::GapSettings settings;
  gap.beyond_noise = 0.99 * settings.warn;
  EXPECT_EQ(gap.level(settings), node::GapLevel::ok);
  gap.beyond_noise = settings.warn;
  EXPECT_EQ(gap.level(settings), node::GapLevel::warn);
  gap.beyond_noise = settings.error;
  EXPECT_EQ(gap.level(settings), node::GapLevel::error);
}

TEST(GapTracker, TellsAGapThatGrows) {
  // The stiffness error grows by 1 % per second. The window delays the gap by half its length, but keeps its slope.
  node::GapSettings settings;
  settings.window = 4.0;
  node::GapTracker tracker(settings);
  node::GapMonitor monitor;
  monitor.addMeasured(-1, 0.0);
  node::LiveGap gap;
  for (int i = 0; i < 20000; ++i) {
    const double time = kStep * i;
    const double displacement = kAmplitude * std::sin(kOmega * time);
    const double force = kStiffness * displacement;
    const std::int64_t stamp = static_cast<std::int64_t>(i) * 1000000;
    monitor.addSimulated(stamp, displacement, force);
    monitor.addMeasured(stamp, force * (1.0 + 0.01 * time));
    if (i % 1000 == 999) {
      gap = tracker.update(monitor.window(settings.window));
    }
  }
  ASSERT_TRUE(gap.known);
  // The derivative of e/(1+e) is 0.01/(1+e)^2, which is 0.0072 to 0.0096 for e from 0.18 to 0.02.
  EXPECT_GT(gap.trend, 0.0070);
  EXPECT_LT(gap.trend, 0.0098);
}

}  // namespace
}  // namespace rubber_suspension
