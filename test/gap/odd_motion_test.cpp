// Logs whose motion is unusual for a component, such as millimetres in a column of metres, and logs with usual motion.
#include "gap/odd_motion.h"

#include "support/kit.h"

namespace rubber_suspension {
namespace {

constexpr double kStiffness = 3e6;

log::Log sine(double amplitude, double stiffness) {
  const auto motion = [&](int i) { return amplitude * std::sin(0.1 * i); };
  return stiffness > 0.0 ? logOf("", 100, 1000000, motion, [&](int /*i*/, double z) { return stiffness * z; })
                         : logOf("", 100, 1000000, motion);
}

const io::ComponentDescription kPlain{"plain", {spring(kStiffness)}};

io::ComponentDescription withFriction() {
  io::ComponentDescription description = kPlain;
  description.add = {friction(1500.0, 2e-3)};
  return description;
}

TEST(OddMotion, ByTheStiffnessOfTheLog) {
  // If 1.9 mm are read as 1.9 m, or kilonewtons as newtons, the log is a thousand times too soft for 3e6 N/m.
  EXPECT_THAT(gap::oddMotion(sine(1.9, kStiffness / 1000.0), kPlain).value_or(""),
              HasSubstr("1e+03 times softer than the model predicts"));
  EXPECT_THAT(gap::oddMotion(sine(1.9e-6, kStiffness * 1000.0), kPlain).value_or(""), HasSubstr("times stiffer"));
  for (const double factor : {0.05, 1.0, 20.0}) {  // suggests another component, not another unit
    EXPECT_FALSE(gap::oddMotion(sine(2e-3, factor * kStiffness), kPlain)) << factor;
  }
  // A long stroke with a force that fits the component is no error of units.
  EXPECT_FALSE(gap::oddMotion(sine(1.0, kStiffness), withFriction()));
}

TEST(OddMotion, ByTheComponentsOwnAmplitudeWithoutAForce) {
  EXPECT_EQ(gap::motionScaleOf(withFriction()), 2e-3);
  EXPECT_THAT(gap::oddMotion(sine(1.9, 0.0), withFriction()).value_or(""),
              HasSubstr("times the component's nominal amplitude of 0.002 m"));
  EXPECT_TRUE(gap::oddMotion(sine(0.25, 0.0), withFriction()));
  EXPECT_FALSE(gap::oddMotion(sine(0.15, 0.0), withFriction()));
}

TEST(OddMotion, ByTheTravelOfAnyRubberWhereNothingElseIsKnown) {
  EXPECT_FALSE(gap::motionScaleOf(kPlain));
  EXPECT_THAT(gap::oddMotion(sine(1.9, 0.0), kPlain).value_or(""), HasSubstr("more than the travel of any rubber"));
  EXPECT_FALSE(gap::oddMotion(sine(0.1, 0.0), kPlain));
}

TEST(OddMotion, SaysNothingOfAForceThatStandsStill) {
  log::Log log = sine(2e-3, kStiffness);
  std::fill(log.force.begin(), log.force.end(), 7.0);
  EXPECT_FALSE(gap::oddMotion(log, kPlain));
}

TEST(OddAmplitude, IsThatOfAnOptionInMetres) {
  EXPECT_THAT(gap::oddAmplitude(5.0, {2e-3}).value_or(""),
              HasSubstr("5 m is 2.5e+03 times the component's nominal amplitude of 0.002 m"));
  EXPECT_FALSE(gap::oddAmplitude(5e-3, {2e-3}));
}

}  // namespace
}  // namespace rubber_suspension
