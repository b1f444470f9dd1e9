// Iwan's bank of sliders and Coulomb friction: minor loops, Masing's rules, closed forms, limits.
#include "rubber_suspension/element/slider_bank.h"

#include "element/driver.h"
#include "rubber_suspension/element/iwan.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

// Returns the force [N] at a displacement that is reached from rest without a reversal.
double backbone(const element::SliderBank& law, double displacement) {
  double force = 0.0;
  for (const element::JenkinsSlider& slider : law.sliders()) {
    force += slider.stiffness * std::clamp(displacement, -slider.yield_displacement, slider.yield_displacement);
  }
  return force;
}

TEST(Iwan, BackboneReachesHalfAtItsDisplacementAndAllAtTheEnd) {
  for (const int count : {2, 3, 4, 16, 17, 64}) {
    const element::SliderBank law(element::iwanSliders(5e3, 2.2e-3, count));
    EXPECT_EQ(law.sliders().size(), static_cast<std::size_t>(count));
    EXPECT_NEAR(backbone(law, 2.2e-3), 2.5e3, 1e-8) << count;
    EXPECT_NEAR(backbone(law, 50.0 * 2.2e-3), 5e3, 1e-8) << count;
    EXPECT_NEAR(backbone(law, 1.0), 5e3, 1e-8) << count;
    for (const element::JenkinsSlider& slider : law.sliders()) {
      EXPECT_GT(slider.stiffness, 0.0) << count;
    }
  }
}

// The backbone of many sliders is within 4 % of the hyperbola of Berg's first loading, because it ends at 50 z2.
TEST(Iwan, BackboneIsCloseToBergs) {
  const element::SliderBank law(element::iwanSliders(5.0, 2.2, 64));
  for (const double z : {0.2, 1.0, 2.0, 4.0, 10.0}) {
    EXPECT_NEAR(backbone(law, z), 5.0 * z / (2.2 + z), 0.04 * backbone(law, z)) << z;
  }
}

TEST(Iwan, FirstLoadingFollowsTheBackbone) {
  const element::SliderBank law(element::iwanSliders(5.0, 2.2, 16));
  Driver driver("iwan maximum_force=5 displacement=2.2");
  for (const double z : {0.1, 1.0, 3.0, 200.0}) {
    EXPECT_NEAR(driver.step(1.0, z), backbone(law, z), 1e-12);
  }
}

TEST(Iwan, MinorLoopClosesToTheLastBit) {
  const element::SliderBank law(element::iwanSliders(5.0, 2.2, 16));
  Driver driver("iwan maximum_force=5 displacement=2.2");
  const double left = driver.step(1.0, 2.0);
  driver.step(1.0, 1.5);
  driver.step(1.0, 1.8);
  driver.step(1.0, 1.6);
  EXPECT_EQ(driver.step(1.0, 2.0), left);
  EXPECT_NEAR(driver.step(1.0, 3.0), backbone(law, 3.0), 1e-12) << "goes on along the backbone";
}

// By Masing's rules, the settled peak lies on the backbone, and the branch after a reversal is the doubled backbone.
// The peak is 2.37 in this example, compared with 1.99 for Berg's element.
TEST(Iwan, SettledLoopObeysMasing) {
  const element::SliderBank law(element::iwanSliders(5.0, 2.2, 16));
  Driver driver("iwan maximum_force=5 displacement=2.2");
  for (const double z : {2.0, -2.0, 2.0, -2.0}) {
    driver.step(1.0, z);
  }
  EXPECT_NEAR(driver.output(), -backbone(law, 2.0), 1e-12);
  EXPECT_NEAR(backbone(law, 2.0), 2.37, 0.03);
  EXPECT_NEAR(driver.step(1.0, -0.7), -backbone(law, 2.0) + 2.0 * backbone(law, 1.3 / 2.0), 1e-12);
}

TEST(SliderBank, LossOfASettledLoopInClosedForm) {
  const element::SliderBank law({{2.0, 400.0}, {0.1, 2000.0}, {0.5, 1000.0}});
  constexpr double kAmplitude = 1.5;
  double expected = 0.0;  // sum of the loop areas of all sliders that slide
  for (const element::JenkinsSlider& slider : law.sliders()) {
    expected += 4.0 * slider.maximumForce() * std::max(0.0, kAmplitude - slider.yield_displacement);
  }
  Driver driver("iwan_table yield_displacement=2,0.1,0.5 stiffness=400,2000,1000");
  // All kinks lie on one of the 3000 steps (1 um of 3 mm), so the trapezoidal rule is exact.
  EXPECT_NEAR(settledWork(driver, kAmplitude, 2, 3000), expected, 1e-9 * expected);
}

TEST(SliderBank, RestsAnywhereWithoutForce) {
  Driver driver("iwan_table yield_displacement=2,0.1 stiffness=400,2000", 5.0);
  EXPECT_EQ(driver.output(), 0.0);
  EXPECT_NEAR(driver.step(1.0, 5.05), 0.05 * 2400.0, 1e-9);
}

TEST(CoulombFriction, SticksSlidesAndTurnsAtOnce) {
  Driver driver("coulomb_friction maximum_force=2e3 stiffness=1e7");
  EXPECT_NEAR(driver.step(1.0, 1e-4), 1e3, 1e-9);
  EXPECT_NEAR(driver.step(1.0, 1e-3), 2e3, 1e-9);
  EXPECT_NEAR(driver.step(1.0, 1e-3 - 4e-4), -2e3, 1e-9) << "2 F_max/k of way back";
  EXPECT_NEAR(driver.step(1.0, -1.0), -2e3, 1e-9);
}

TEST(CoulombFriction, LossTendsToThatOfCoulombsLaw) {
  constexpr double kAmplitude = 1e-3;
  Driver driver("coulomb_friction maximum_force=2e3 stiffness=1e10");
  const double coulomb = 4.0 * 2e3 * kAmplitude;
  // The loss is smaller by F_max/(k A) = 2e-4. Steps of 1 um add half a step at each of the two turns, 1e-3.
  EXPECT_NEAR(settledWork(driver, kAmplitude, 1, 2000), coulomb, 2e-3 * coulomb);
}

}  // namespace
}  // namespace rubber_suspension::test
