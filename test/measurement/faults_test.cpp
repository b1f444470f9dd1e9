// Spikes, held values and saturation are found and excluded. Sharp corners, stops and standstills are not mistaken for
// such faults.
#include "rubber_suspension/measurement/faults.h"

#include "measurement/examine.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/measurement/prepared_log.h"
#include "support/test.h"

namespace rubber_suspension::measurement {
namespace {

TEST(Faults, FindsSpikes) {
  for (const double size : {0.05, 0.2, 0.5}) {
    Perturbation p;
    p.spikes = size;
    int found = 0;
    int all = 0;
    for (const VirtualRig& rig : allRigs(3)) {
      const VirtualLog log = runRig(rig, p);
      const Mask usable = findFaults(log.log).usable();
      for (const Eigen::Index spike : log.spikes) {
        found += usable[spike] ? 0 : 1;
        ++all;
      }
      EXPECT_LT(usable.size() - usable.count(), 15);  // six spikes of one or two samples, and few other samples
    }
    std::cout << "spikes of " << size << ": " << found << " of " << all << "\n";
    EXPECT_GE(found, 0.95 * all);
  }
}

// The spikes of one or two samples are small relative to the force, but large relative to the noise.
TEST(Faults, FindsSpikesAboveTheNoise) {
  int found = 0;
  int all = 0;
  for (const VirtualRig& rig : allRigs(3)) {
    VirtualLog log = runRig(rig);
    for (std::size_t i = 1; i < 10; ++i) {
      const double size = (i % 3 == 0 ? -20.0 : 20.0) * log.noise;
      log.log.force[979 * i] += size;
      log.log.force[979 * i + 1] += i % 2 == 0 ? size : 0.0;
    }
    const Mask usable = findFaults(log.log).usable();
    for (Eigen::Index i = 1; i < 10; ++i) {
      found += usable[979 * i] ? 0 : 1;
      ++all;
    }
    EXPECT_LE(usable.size() - usable.count(), 18);
  }
  std::cout << "spikes above the noise: " << found << " of " << all << "\n";
  EXPECT_GE(found, 0.9 * all);
}

// At a jump of the velocity, the force of a mass has a peak of one sample. Noise may hide the jump in the displacement.
TEST(Faults, LeavesPeaksOfAMassAlone) {
  const Eigen::Index count = 4000;
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  Eigen::VectorXd z(count);
  Eigen::VectorXd f(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index phase = i % 800;
    const double motion = static_cast<double>(std::clamp<Eigen::Index>(phase, 200, 600) - 400) * 1e-2;
    z[i] = motion * (i / 800 % 2 == 0 ? 1.0 : -1.0) + 5e-3 * normal(generator);
    f[i] = motion * (i / 800 % 2 == 0 ? 1.0 : -1.0) + 1e-2 * normal(generator);
    const double jump = phase == 200 ? 1.0 : phase == 600 ? -1.0 : 0.0;
    f[i] += 0.2 * jump * (i / 800 % 2 == 0 ? 1.0 : -1.0);
  }
  EXPECT_TRUE(findFaults("mass", z, f).findings.empty());
  f[1700] += 0.2;
  const Faults faults = findFaults("mass", z, f);
  EXPECT_FALSE(faults.force[1700]);
  EXPECT_EQ(faults.usable().count(), count - 1);
}

// A fast motion passes through a clearance within a few samples.
TEST(Faults, LeavesAClearanceAlone) {
  const Eigen::Index count = 8000;
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  Eigen::VectorXd z(count);
  Eigen::VectorXd f(count);
  for (const double clearance : {0.01, 0.02, 0.05}) {
    for (Eigen::Index i = 0; i < count; ++i) {
      const double frequency = 0.002 + 6e-6 * static_cast<double>(i);
      z[i] = std::sin(element::kPi * static_cast<double>(i) * (0.002 + frequency)) / std::hypot(1.0, frequency / 0.006);
      f[i] = z[i] - std::clamp(z[i], -clearance, clearance) + 2e-3 * normal(generator);
    }
    const Faults faults = findFaults("clearance", z, f);
    EXPECT_TRUE(faults.findings.empty()) << faults.findings.front().text;
  }
}

TEST(Faults, FindsHeldValues) {
  for (const int samples : {10, 25, 60}) {
    Perturbation p;
    p.held = samples;
    int found = 0;
    int all = 0;
    for (const VirtualRig& rig : allRigs(3)) {
      if (rig.motion == Motion::holds) {
        continue;  // most held values would lie where the displacement is constant anyway
      }
      const Faults faults = findFaults(runRig(rig, p).log);
      found += static_cast<int>(faults.force.size() - faults.force.count());
      all += 3 * (samples - 1);
    }
    std::cout << "held for " << samples << " samples: " << found << " of " << all << "\n";
    EXPECT_GE(found, (samples > 10 ? 0.9 : 0.75) * all);  // short holds may lie at a turning point of the motion
    EXPECT_LE(found, all);
  }
}

TEST(Faults, FindsSaturation) {
  for (const double share : {0.02, 0.05, 0.1}) {
    Perturbation p;
    p.clipped = share;
    int found = 0;
    const std::vector<VirtualRig> rigs = allRigs(3);
    for (const VirtualRig& rig : rigs) {
      const VirtualLog log = runRig(rig, p);
      const Faults faults = findFaults(log.log);
      const double top = *std::max_element(log.log.force.begin(), log.log.force.end());
      const bool left_out = !faults.force[static_cast<Eigen::Index>(
          std::find(log.log.force.begin(), log.log.force.end(), top) - log.log.force.begin())];
      found += left_out ? 1 : 0;
    }
    std::cout << "clipped by " << share << ": " << found << " of " << rigs.size() << "\n";
    EXPECT_GE(found, 0.9 * static_cast<double>(rigs.size()));
  }
}

// The displacement is a noise-free triangle that pauses at its ends. The force hits a stop in each cycle.
TEST(Faults, LeavesCornersAndStopsAlone) {
  const Eigen::Index count = 4000;
  Eigen::VectorXd z(count);
  Eigen::VectorXd f(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double phase = std::fmod(static_cast<double>(i) / 200.0, 1.0);
    z[i] = phase < 0.4 ? -1.0 + 5.0 * phase : (phase < 0.5 ? 1.0 : (phase < 0.9 ? 1.0 - 5.0 * (phase - 0.5) : -1.0));
    f[i] =
        10.0 * z[i] + 500.0 * std::pow(std::max(z[i] - 0.98, 0.0), 1.0) + 0.3 * std::sin(37.1 * static_cast<double>(i));
  }
  const Faults faults = findFaults("triangle", z, f);
  EXPECT_TRUE(faults.findings.empty()) << faults.findings.front().text;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double sine = std::sin(2.0 * element::kPi * static_cast<double>(i) / 40.0);
    z[i] = sine;
    f[i] = 10.0 * sine + 2000.0 * std::max(sine - 0.99, 0.0) + 0.02 * std::sin(37.1 * static_cast<double>(i));
  }
  EXPECT_TRUE(findFaults("stop", z, f).findings.empty());
}

// A free play causes a corner of the force at the same displacement in each cycle. A spike there is far sharper.
TEST(Faults, FindsASpikeWhereTheForceHasCorners) {
  const Eigen::Index count = 4000;
  Eigen::VectorXd z(count);
  Eigen::VectorXd f(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    z[i] = std::sin(2.0 * element::kPi * static_cast<double>(i) / 200.0);
    f[i] = z[i] - std::clamp(z[i], -0.3, 0.3);
  }
  EXPECT_TRUE(findFaults("play", z, f).findings.empty());
  Eigen::Index corner = 1000;
  while (z[corner] < 0.3) {
    ++corner;
  }
  f[corner] -= 1.0;
  const Faults faults = findFaults("play", z, f);
  EXPECT_FALSE(faults.force[corner]);
  EXPECT_LE(count - faults.usable().count(), 2);
}

// At the end of a ramp both channels have a corner. A spike is far sharper than this corner.
TEST(Faults, FindsASpikeWhereTheMotionTurns) {
  const Eigen::Index count = 4000;
  Eigen::VectorXd z(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    z[i] = std::abs(std::fmod(static_cast<double>(i) / 100.0, 2.0) - 1.0);
  }
  Eigen::VectorXd f = 3.0 * z;
  EXPECT_TRUE(findFaults("triangle", z, f).findings.empty());
  f[1000] += 3.0;
  const Faults faults = findFaults("triangle", z, f);
  EXPECT_FALSE(faults.force[1000]);
  EXPECT_LE(count - faults.usable().count(), 2);
}

// A blow affects both channels in the same sample. Spikes of the two channels in neighbouring samples are no blow.
TEST(Faults, FindsSpikesOfBothChannelsNextToEachOther) {
  const Eigen::Index count = 4000;
  const Eigen::VectorXd z = Eigen::VectorXd::LinSpaced(count, 0.0, 80.0 * element::kPi).array().sin();
  for (const Eigen::Index apart : {2, 3, -2, -3}) {
    Eigen::VectorXd displacement = z;
    Eigen::VectorXd force = 3.0 * z;
    displacement[1000] += 1.5;
    force[1000 + apart] -= 9.0;
    const Faults faults = findFaults("spikes", displacement, force);
    EXPECT_FALSE(faults.displacement[1000]) << apart;
    EXPECT_FALSE(faults.force[1000 + apart]) << apart;
    EXPECT_LE(count - faults.usable().count(), 4) << apart;
  }
  Eigen::VectorXd displacement = z;
  Eigen::VectorXd force = 3.0 * z;
  displacement[1000] += 0.5;
  force[1000] += 1.5;
  EXPECT_TRUE(findFaults("blow", displacement, force).findings.empty());
}

// The force of friction alone stays at its limit while the displacement changes.
TEST(Faults, LeavesFrictionAlone) {
  const Eigen::Index count = 4000;
  Eigen::VectorXd z(count);
  Eigen::VectorXd f(count);
  double force = 0.0;
  for (Eigen::Index i = 0; i < count; ++i) {
    z[i] = std::sin(2.0 * element::kPi * static_cast<double>(i) / 200.0);
    force = i > 0 ? std::clamp(force + 20.0 * (z[i] - z[i - 1]), -1.0, 1.0) : 0.0;
    f[i] = force;
  }
  const Faults faults = findFaults("friction", z, f);
  EXPECT_TRUE(faults.findings.empty()) << faults.findings.front().text;
}

TEST(Faults, BridgesWhatIsLeftOut) {
  log::Log log;
  for (int i = 0; i < 5; ++i) {
    log.stamp.push_back(i);
    log.displacement.push_back(i == 2 ? 99.0 : i);
    log.force.push_back(i == 4 ? 99.0 : 2.0 * i);
  }
  Faults faults;
  faults.displacement = Mask::Constant(5, true);
  faults.force = faults.displacement;
  faults.displacement[2] = false;
  faults.force[4] = false;
  const log::Log result = repaired(log, faults);
  EXPECT_DOUBLE_EQ(result.displacement[2], 2.0);
  EXPECT_DOUBLE_EQ(result.force[4], 6.0);  // the last valid value
}

TEST(Faults, OfALogThatIsRefusedTheOneThatExcludesMostIsNamed) {
  log::Log log;
  for (int i = 0; i < 8000; ++i) {
    const double z = std::sin(0.0157 * i);
    log.stamp.push_back(static_cast<std::int64_t>(i) * 2000000);
    log.displacement.push_back(1e-3 * z);
    log.force.push_back(std::clamp(1e3 * z, -450.0, 450.0) + (i % 800 == 7 ? 200.0 : 0.0));  // every 2nd cycle
  }
  const std::string text = messageOf<log::LogError>([&] { prepareLog(log); });
  EXPECT_THAT(text, testing::HasSubstr("samples are usable"));
  EXPECT_THAT(text, testing::HasSubstr("(clipped)"));
}

// A force with a phase shift saturates while the displacement still changes. Friction does the same, but leaves its
// limit only where the displacement turns. More than half of the samples are saturated, so saturation must be named,
// not the 16 spikes.
TEST(Faults, FindsSaturationOfAForceThatIsNotInPhase) {
  for (const double phase : {-1.5, -0.5, 0.0, 0.5, 1.5}) {
    log::Log log;
    for (int i = 0; i < 8000; ++i) {
      log.stamp.push_back(static_cast<std::int64_t>(i) * 2000000);
      log.displacement.push_back(1e-3 * std::sin(0.0157 * i));
      log.force.push_back(std::clamp(1e3 * std::sin(0.0157 * i + phase), -450.0, 450.0) +
                          (i * 7919 % 8000 < 16 ? 200.0 : 0.0));
    }
    const std::string text = messageOf<log::LogError>([&] { prepareLog(log); });
    EXPECT_THAT(text, HasSubstr("samples are usable")) << phase;
    EXPECT_THAT(text, HasSubstr("(clipped)")) << phase;
  }
}

TEST(HuberWeights, FallBeyondTheBend) {
  const Eigen::VectorXd weights = huberWeights(Eigen::Vector3d(0.5, -1.345, 13.45));
  EXPECT_DOUBLE_EQ(weights[0], 1.0);
  EXPECT_DOUBLE_EQ(weights[1], 1.0);
  EXPECT_DOUBLE_EQ(weights[2], 0.1);
}

}  // namespace
}  // namespace rubber_suspension::measurement
