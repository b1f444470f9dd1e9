// Errors of rigs are found, with intervals that contain the true value. A rig without errors has no findings.
#include "rubber_suspension/measurement/rig_model.h"

#include "measurement/examine.h"
#include "rubber_suspension/measurement/prepared_log.h"
#include "support/kit.h"

namespace rubber_suspension::measurement {
namespace {

// In 99 of 100 runs, at least this share of 24 to 36 intervals (95 %) contains the true value (binomial).
constexpr double kCovered = 0.84;
constexpr double kFalse = 0.05;  // largest rate of false findings per log

double nothing(const VirtualLog&) { return 0.0; }

TEST(RigModel, FindsNothingWhereNothingWasDone) {
  Perturbation pink;
  pink.pink = true;
  Perturbation filtered;
  filtered.anti_alias = 0.1;
  const std::vector<VirtualRig> rigs = allRigs(5);
  for (const auto& [label, p] : {std::make_pair("clean", Perturbation()), {"1/f", pink}, {"filtered", filtered}}) {
    const Rate rate = rateOf(rigs, p, "none", nothing, label);
    EXPECT_LE(rate.share(rate.others), kFalse) << label;
  }
}

// An offset is found if the motion identifies it. With a linear component, both offsets have the same effect.
TEST(RigModel, FindsZeros) {
  for (const double size : {0.002, 0.01, 0.03}) {
    Perturbation p;
    p.force_zero = size;
    const Rate rate =
        rateOf(allRigs(3), p, finding::kForceZero, [](const VirtualLog& log) { return log.force_zero; }, "force zero");
    // With a progressive spring, a small offset of the force may be attributed to the displacement.
    EXPECT_GE(rate.share(rate.found), 0.85);
    EXPECT_GE(rate.covered, kCovered * rate.found);
    EXPECT_LE(rate.share(rate.others), kFalse);
  }
}

TEST(RigModel, FindsDisplacementZeroOfProgressiveSpring) {
  for (const double size : {0.002, 0.01, 0.03}) {
    Perturbation p;
    p.displacement_zero = size;
    std::vector<VirtualRig> rigs = allRigs(6);
    rigs.erase(
        std::remove_if(rigs.begin(), rigs.end(), [](const VirtualRig& rig) { return rig.law != Law::progressive; }),
        rigs.end());
    const Rate rate = rateOf(
        rigs, p, finding::kDisplacementZero, [](const VirtualLog& log) { return log.displacement_zero; },
        "displacement zero");
    EXPECT_GE(rate.share(rate.found), size > 0.005 ? 0.6 : 0.3);
    EXPECT_GE(rate.covered, kCovered * rate.found);
  }
}

// Both offsets are removed from the residual, even if one is attributed to the other channel.
TEST(RigModel, TakesZerosOut) {
  Perturbation p;
  p.force_zero = 0.03;
  p.displacement_zero = -0.02;
  for (const VirtualRig& rig : allRigs(1)) {
    const VirtualLog log = runRig(rig, p);
    const Examined examined = examine(log, elementsOf(rig));
    const double left = std::sqrt(examined.fit.residual.squaredNorm() / static_cast<double>(examined.record.size()));
    EXPECT_LT(left, 1.05 * log.noise);  // the fit to 10000 samples reduces the noise by less than this
    EXPECT_GT(left, 0.95 * log.noise);
  }
}

TEST(RigModel, FindsDelay) {
  for (const double size : {0.2, 0.5, 1.0}) {
    Perturbation p;
    p.delay = size;
    const Rate rate = rateOf(allRigs(3), p, finding::kDelay, [](const VirtualLog& log) { return log.delay; }, "delay");
    EXPECT_GE(rate.share(rate.found), 0.95);
    EXPECT_GE(rate.covered, kCovered * rate.found);
    EXPECT_LE(rate.share(rate.others), kFalse);
  }
}

TEST(RigModel, FindsGainAndClock) {
  for (const double size : {0.003, 0.005, 0.01}) {
    Perturbation p;
    p.gain = size;
    const Rate rate = rateOf(allRigs(3), p, finding::kSensorGain, [size](const VirtualLog&) { return size; }, "gain");
    EXPECT_GE(rate.share(rate.found), 0.95);
    EXPECT_GE(rate.covered, kCovered * rate.found);
    EXPECT_LE(rate.share(rate.others), kFalse);
  }
  for (const double size : {3e-5, 1e-4, 2e-4}) {
    Perturbation p;
    p.clock = size;
    const Rate rate = rateOf(allRigs(3), p, finding::kClock, [size](const VirtualLog&) { return size; }, "clock");
    // In slow motion, the smallest clock error has an effect below a tenth of the noise: 0.3 ms at the ends of the log.
    EXPECT_GE(rate.share(rate.found), size > 5e-5 ? 0.95 : 0.7);
    EXPECT_GE(rate.covered, kCovered * rate.found);
    EXPECT_LE(rate.share(rate.others), kFalse);
  }
}

TEST(RigModel, FindsRunningStart) {
  Perturbation p;
  p.running_start = true;
  std::vector<VirtualRig> rigs = allRigs(6);
  rigs.erase(
      std::remove_if(rigs.begin(), rigs.end(), [](const VirtualRig& rig) { return rig.motion == Motion::holds; }),
      rigs.end());  // holds start at rest
  const Rate rate =
      rateOf(rigs, p, finding::kRunningStart, [](const VirtualLog& log) { return log.transient; }, "running start");
  EXPECT_GE(rate.covered, kCovered * rate.found);
  EXPECT_GE(rate.share(rate.found), 0.4);  // the transients of other rigs are below the noise
  EXPECT_LE(rate.share(rate.others), 2.0 * kFalse);
}

TEST(RigModel, ScalesWithTheBench) {
  Perturbation p;
  p.force_zero = 0.02;
  p.delay = 0.6;
  p.spikes = 0.2;
  const VirtualRig rig;
  const Examined reference = examine(runRig(rig, p), elementsOf(rig));
  for (const auto& [length, force, time] : {std::array<double, 3>{0.01, 1.0, 1.0},
                                            {100.0, 1.0, 1.0},
                                            {1.0, 1e-3, 1.0},
                                            {1.0, 1e3, 1.0},
                                            {1.0, 1.0, 1.0 / 30.0},
                                            {1.0, 1.0, 100.0}}) {
    VirtualRig scaled = rig;
    scaled.length = length;
    scaled.force = force;
    scaled.time = time;
    const Examined examined = examine(runRig(scaled, p), elementsOf(scaled));
    ASSERT_EQ(examined.findings.size(), reference.findings.size()) << length << " " << force << " " << time;
    for (std::size_t i = 0; i < examined.findings.size(); ++i) {
      const RigFinding& one = examined.findings[i];
      const RigFinding& other = reference.findings[i];
      EXPECT_EQ(one.finding, other.finding);
      const double scale = one.unit == "N" ? force : (one.unit == "m" ? length : (one.unit == "s" ? time : 1.0));
      // The tolerance covers stamps in whole nanoseconds and the rounding of sums.
      EXPECT_NEAR(one.value, scale * other.value, 1e-3 * scale * std::abs(other.value)) << one.finding;
    }
  }
}

TEST(RigModel, FindsTheSameTheOtherWayRound) {
  Perturbation p;
  p.force_zero = 0.02;
  p.delay = 0.6;
  p.spikes = 0.2;
  const VirtualRig rig;
  VirtualLog log = runRig(rig, p);
  const Examined reference = examine(log, elementsOf(rig));
  for (std::size_t i = 0; i < log.log.size(); ++i) {
    log.log.displacement[i] *= -1.0;
    log.log.force[i] *= -1.0;
  }
  const Examined turned = examine(log, elementsOf(rig));
  ASSERT_EQ(turned.findings.size(), reference.findings.size());
  for (std::size_t i = 0; i < turned.findings.size(); ++i) {
    const double sign = turned.findings[i].finding == finding::kForceZero ? -1.0 : 1.0;
    EXPECT_EQ(turned.findings[i].finding, reference.findings[i].finding);
    EXPECT_NEAR(turned.findings[i].value, sign * reference.findings[i].value,
                1e-6 * std::abs(reference.findings[i].value));
  }
}

TEST(InitialStates, AreNoneOfALogThatStartsAtRest) {
  const log::Record record = prepareLog(runRig(allRigs(1).front()).log).record;
  const Eigen::MatrixXd none = initialStates({record}, {}, {record.force}, {}).front();
  EXPECT_EQ(none.rows(), record.size());
  EXPECT_EQ(none.cols(), 0);
}

// A ramp from the first sample on, as in a relaxation test, moves at once, but starts unloaded and at rest.
TEST(RigModel, ARampFromRestDoesNotStartInMotion) {
  log::Log log = logOf(
      "ramp", 4000, 2000000, [](int i) { return 1e-3 * std::min(1.0, i / 200.0); },
      [](int i, double z) { return 1e6 * z * (1.0 + 0.3 * std::exp(-std::max(0, i - 200) / 500.0)); });
  EXPECT_FALSE(startsInMotion(log::makeRecord(log)));
  for (double& force : log.force) {
    force += 300.0;  // the force that an earlier motion may leave behind
  }
  EXPECT_TRUE(startsInMotion(log::makeRecord(log)));
}

// The log starts during a ramp to a hold. The fit excludes the start, the standard deviation of the force does not.
TEST(PrepareLog, ScalesByTheForceOfTheStartToo) {
  std::mt19937 generator(3);
  std::normal_distribution<double> noise(0.0, 20.0);
  log::Log log = logOf(
      "hold", 5000, 4000000, [](int i) { return i < 250 ? 1e-3 * (1.0 - i / 250.0) : 0.0; },
      [&](int /*i*/, double z) { return 1e6 * z + noise(generator); });
  const Eigen::Map<const Eigen::VectorXd> force(log.force.data(), 5000);
  const log::Record record = prepareLog(log).record;
  ASSERT_GT(record.counts.size(), 0) << "starts in motion";
  EXPECT_EQ(record.counts[0], 0.0);
  EXPECT_NEAR(record.force_deviation, std::sqrt((force.array() - force.mean()).square().mean()), 1.0);
}

TEST(RigModel, RefusesMasksOfOtherSize) {
  const VirtualRig rig;
  const log::Record record = log::makeRecord(runRig(rig).log);
  EXPECT_THROW(RigModel({record}, {Mask::Constant(3, true)}, {}), std::invalid_argument);
  EXPECT_THROW(RigModel({record, record}, {Mask::Constant(record.size(), true)}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace rubber_suspension::measurement
