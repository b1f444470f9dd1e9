// A branch along a curve of two numbers: the curve, its side, and what is refused.
#include "rubber_suspension/element/along_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "element/driver.h"
#include "rubber_suspension/element/catalogue.h"
#include "support/message_of.h"

namespace rubber_suspension::test {
namespace {

constexpr double kReach = 2e-3;  // [m]
constexpr double kTip = 3e6;     // stiffness there [N/m]
constexpr double kGrowth = 3.0;

element::ElementDescription grown(double side, std::vector<double> displacement = {kReach}) {
  return {"maxwell_along_curve",
          {{"stiffness", {kTip}},
           {"displacement", std::move(displacement)},
           {"break_frequency", {1e-6}},
           {"growth", {kGrowth}},
           {"side", {side}}}};
}

// Force of a short step about a place, over the step: a branch that does not relax meanwhile.
double stiffnessAt(double side, double z) {
  const element::ElementPointer made = element::makeElement(grown(side));
  const auto& law = dynamic_cast<const element::MaxwellAlongCurve&>(*element::parallelLaw(made));
  Driver<element::MaxwellAlongCurve> driver(law, z);
  return driver.step(1e-3, z + 1e-9) / 1e-9;
}

// Between its points a stiffness that is linear errs by h^2 k''/8, 0.3 % of the stiffness here at most.
TEST(MaxwellAlongCurve, GrowsExponentiallyWithTheSquareOfTheDisplacement) {
  for (const double share : {-1.0, -0.5, 0.0, 0.3, 0.8}) {
    const double exact = kTip * std::exp(kGrowth * (share * share - 1.0));
    EXPECT_NEAR(stiffnessAt(0.0, share * kReach), exact, 0.003 * exact) << share;
  }
  EXPECT_NEAR(stiffnessAt(0.0, 1.5 * kReach), kTip, 1e-6 * kTip) << "constant beyond";
}

TEST(MaxwellAlongCurve, GrowsToOneSideAlone) {
  const double at_rest = kTip * std::exp(-kGrowth);
  EXPECT_NEAR(stiffnessAt(1.0, -0.8 * kReach), at_rest, 1e-3 * at_rest);
  EXPECT_GT(stiffnessAt(1.0, 0.8 * kReach), 5.0 * at_rest);
  EXPECT_NEAR(stiffnessAt(-1.0, 0.8 * kReach), at_rest, 1e-3 * at_rest);
}

TEST(MaxwellAlongCurve, RefusesGrowthBesideSeveralPoints) {
  const std::string message = messageOf<std::invalid_argument>([&] {
    element::makeElement(grown(0.0, {-kReach, kReach}));
  });
  EXPECT_EQ(message,
            "maxwell_along_curve.growth: 3 with 2 displacements and 1 stiffnesses; accepted: one displacement greater "
            "than 0 and one stiffness, or no growth");
}

}  // namespace
}  // namespace rubber_suspension::test
