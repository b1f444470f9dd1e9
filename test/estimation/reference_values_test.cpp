// The worked example of the paper: every number of the estimation, to the digits that are known.
#include <gtest/gtest.h>

#include <cmath>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/berg_friction.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension {
namespace {

// The paper states it in kN and mm; here it is in SI.
estimation::Specification example() {
  estimation::Specification specification;
  specification.set("static_stiffness", 3e6);
  specification.set("dynamic_stiffness", 4.2e6);
  specification.set("nominal_frequency", 4.0);
  return specification;
}

estimation::Specification exampleWith(const std::string& key, double value) {
  estimation::Specification specification = example();
  specification.set(key, value);
  return specification;
}

estimation::Specification frictionExample() {
  estimation::Specification specification = exampleWith("relative_damping", 0.05);
  specification.set("nominal_amplitude", 2e-3);
  return specification;
}

estimation::Specification fiveInputs() {
  estimation::Specification specification = exampleWith("maximum_stiffness", 4.9e6);
  specification.set("high_frequency", 25.0);
  return specification;
}

double degrees(double angle) { return angle * 180.0 / element::kPi; }

std::complex<double> stiffness(const std::vector<element::ElementDescription>& elements, double frequency) {
  return component::Component(elements).complexStiffness(frequency).value();
}

// Tolerances are half of the last digit that is known.
TEST(ReferenceValues, KelvinVoigt) {
  const auto elements = estimation::estimate(estimation::Model::kelvin_voigt, [] {
    estimation::Specification specification;
    specification.set("dynamic_stiffness", 4.2e6);
    specification.set("nominal_frequency", 4.0);
    specification.set("relative_damping", 0.05);
    return specification;
  }());
  ASSERT_EQ(elements.size(), 2u);
  EXPECT_DOUBLE_EQ(elements[0].value("stiffness"), 4.2e6);
  EXPECT_NEAR(elements[1].value("damping"), 0.01671e6, 0.000005e6);
}

TEST(ReferenceValues, MaxwellByBreakFrequency) {
  const struct {
    double break_frequency, stiffness, angle;
  } rows[] = {{0.5, 1.2160, 2.04}, {1, 1.2638, 4.06}, {2, 1.4497, 7.94}, {4, 2.1264, 14.66}, {8, 4.2250, 23.73}};
  for (const auto& row : rows) {
    const auto elements =
        estimation::estimate(estimation::Model::maxwell, exampleWith("break_frequency", row.break_frequency));
    EXPECT_NEAR(elements[1].value("stiffness"), row.stiffness * 1e6, 0.00005e6);
    EXPECT_NEAR(degrees(std::arg(stiffness(elements, 4.0))), row.angle, 0.005);
  }
}

// The paper prints 1.43 Hz for D_n = 5 %. What follows from the damping, from the rounded 5.7 degrees, and from the
// loss energy of M1, Im K* = 2 D_n K_n at |K*| = K_n, which comes nearest.
TEST(ReferenceValues, MaxwellByLossAngle) {
  const struct {
    std::string key;
    double value, break_frequency, stiffness;
  } rows[] = {{"relative_damping", 0.05, 1.4177, 1.32727e6},
              {"loss_angle", 5.7 * element::kPi / 180.0, 1.4150, 1.32679e6},
              {"loss_angle", std::asin(2.0 * 0.05), 1.4250, 1.3286e6}};
  for (const auto& row : rows) {
    const auto elements = estimation::estimate(estimation::Model::maxwell, exampleWith(row.key, row.value));
    EXPECT_NEAR(elements[1].value("break_frequency"), row.break_frequency, 0.00005) << row.key;
    EXPECT_NEAR(elements[1].value("stiffness"), row.stiffness, 60.0) << row.key;  // half of the last digit, at most
  }
}

TEST(ReferenceValues, MaxwellDashpot) {
  estimation::Specification specification = exampleWith("break_frequency", 0.5);
  specification.set("relative_damping", 0.05);
  const auto elements = estimation::estimate(estimation::Model::maxwell_dashpot, specification);
  EXPECT_NEAR(elements[1].value("stiffness"), 1.198e6, 0.0005e6);
  EXPECT_NEAR(elements[2].value("damping"), 0.01076e6, 0.000005e6);
}

TEST(ReferenceValues, Friction) {
  const auto elements = estimation::estimate(estimation::Model::friction, frictionExample());
  EXPECT_NEAR(elements[1].value("maximum_force"), 6047.5, 0.05);
  EXPECT_NEAR(elements[1].value("displacement"), 2.1760e-3, 0.00005e-3);
}

TEST(ReferenceValues, FrictionDashpot) {
  const auto elements = estimation::estimate(estimation::Model::friction_dashpot, frictionExample());
  EXPECT_NEAR(elements[1].value("maximum_force"), 7470.0, 0.05);
  EXPECT_NEAR(elements[1].value("displacement"), 3.1976e-3, 0.00005e-3);
  EXPECT_NEAR(elements[2].value("damping"), 3326.0, 0.5);
}

TEST(ReferenceValues, Berg) {
  estimation::Specification specification = frictionExample();
  specification.set("break_frequency", 1.45);
  const auto elements = estimation::estimate(estimation::Model::berg, specification);
  EXPECT_NEAR(elements[1].value("maximum_force"), 4920.9, 0.05);
  EXPECT_NEAR(elements[1].value("displacement"), 2.2109e-3, 0.00005e-3);
  const double k1 = elements[2].value("stiffness");
  EXPECT_NEAR(k1, 0.26087e6, 0.000005e6);
  EXPECT_NEAR(k1 / (2.0 * element::kPi * elements[2].value("break_frequency")), 0.02863e6, 0.000005e6);
}

void expectElements(const std::vector<element::ElementDescription>& elements,
                    const std::vector<double>& break_frequencies, double frequency_tolerance,
                    const std::vector<double>& stiffnesses) {
  ASSERT_EQ(elements.size(), stiffnesses.size() + 1);
  EXPECT_DOUBLE_EQ(elements[0].value("stiffness"), 3e6);
  for (std::size_t i = 0; i < stiffnesses.size(); ++i) {
    EXPECT_NEAR(elements[i + 1].value("break_frequency"), break_frequencies[i], frequency_tolerance);
    EXPECT_NEAR(elements[i + 1].value("stiffness"), stiffnesses[i] * 1e6, 0.00005e6);
  }
}

TEST(ReferenceValues, MultiMaxwellThree) {
  estimation::Specification specification = fiveInputs();
  specification.set("maxwell_elements", 3);
  const auto elements = estimation::estimate(estimation::Model::multi_maxwell, specification);
  expectElements(elements, {1.582, 5.091, 16.384}, 0.0005, {1.0573, 0.5532, 0.2895});
  EXPECT_NEAR(elements[1].value("stiffness") / elements[2].value("stiffness"), 1.911, 0.0005);
  EXPECT_NEAR(degrees(std::arg(stiffness(elements, 4.0))), 9.55, 0.005);
}

TEST(ReferenceValues, MultiMaxwellFive) {
  const auto elements = estimation::estimate(estimation::Model::multi_maxwell, fiveInputs());
  expectElements(elements, {0.0348, 0.1593, 0.7284, 3.3311, 15.2334}, 0.00005,
                 {0.2334, 0.2908, 0.3623, 0.4513, 0.5622});
  EXPECT_NEAR(elements[1].value("stiffness") / elements[2].value("stiffness"), 0.8027, 0.00005);
  EXPECT_NEAR(degrees(std::arg(stiffness(elements, 4.0))), 5.98, 0.005);
}

TEST(ReferenceValues, MultiMaxwellOverFrequency) {
  const double frequencies[] = {0.5, 1, 2, 4, 8, 12, 20};
  const struct {
    double count;
    double stiffness[7], angle[7];
  } models[] = {{3, {3.12, 3.38, 3.80, 4.20, 4.50, 4.63, 4.76}, {6.74, 10.2, 11.2, 9.55, 7.22, 5.87, 4.31}},
                {5, {3.64, 3.81, 3.99, 4.20, 4.41, 4.54, 4.69}, {5.58, 5.82, 5.97, 5.98, 5.61, 5.26, 4.40}}};
  for (const auto& model : models) {
    estimation::Specification specification = fiveInputs();
    specification.set("maxwell_elements", model.count);
    const auto elements = estimation::estimate(estimation::Model::multi_maxwell, specification);
    for (int i = 0; i < 7; ++i) {
      const auto k = stiffness(elements, frequencies[i]);
      EXPECT_NEAR(std::abs(k), model.stiffness[i] * 1e6, 0.005e6);
      EXPECT_NEAR(degrees(std::arg(k)), model.angle[i], model.angle[i] >= 10.0 ? 0.05 : 0.005);
    }
  }
}

TEST(ReferenceValues, MaxwellAtTwentyHertz) {
  const auto elements = estimation::estimate(estimation::Model::maxwell, exampleWith("break_frequency", 1.43));
  EXPECT_NEAR(std::abs(stiffness(elements, 20.0)), 4.32e6, 0.005e6);
}

}  // namespace
}  // namespace rubber_suspension
