// The example of the paper: every estimated number, to all known digits.
#include "estimation/values.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

using estimation::Model;

// The paper has kN and mm. These values are in SI units.
const Values kExample = {{"static_stiffness", 3e6}, {"dynamic_stiffness", 4.2e6}, {"nominal_frequency", 4.0}};
const Values kFrictionExample = kExample + Values{{"relative_damping", 0.05}, {"nominal_amplitude", 2e-3}};
const Values kFiveInputs = kExample + Values{{"maximum_stiffness", 4.9e6}, {"high_frequency", 25.0}};
const Values kThreeElements = with(kFiveInputs, "maxwell_elements", 3);

std::complex<double> stiffness(const std::vector<element::ElementDescription>& elements, double frequency) {
  return component::Component(elements).complexStiffness(frequency).value();
}

double degreesOf(std::complex<double> k) { return std::arg(k) * 180.0 / element::kPi; }

struct Number {
  std::size_t element;
  std::string key;
  double value;
  double tolerance;  // half a unit of the last known digit
};

struct Reference {
  std::string name;
  Model model;
  Values values;
  std::vector<Number> numbers;
  double angle = 0.0;  // at 4 Hz [deg], if known
};

Reference byBreakFrequency(const std::string& name, double break_frequency, double k1, double angle) {
  return {name,
          Model::maxwell,
          with(kExample, "break_frequency", break_frequency),
          {{1, "stiffness", k1 * 1e6, 0.00005e6}},
          angle};
}

// The paper prints 1.43 Hz for D_n = 5 %. It may follow from the damping, from the rounded angle of 5.7 degrees, or
// from the loss energy of M1, Im K* = 2 D_n K_n at |K*| = K_n. The last comes nearest.
Reference byLossAngle(const std::string& name, const std::string& key, double value, double break_frequency,
                      double k1) {
  return {name,
          Model::maxwell,
          with(kExample, key, value),
          {{1, "break_frequency", break_frequency, 0.00005}, {1, "stiffness", k1, 60.0}}};
}

Reference bank(const std::string& name, const Values& values, const std::vector<double>& break_frequencies,
               double frequency_tolerance, const std::vector<double>& stiffnesses, double angle) {
  Reference reference{name, Model::multi_maxwell, values, {{0, "stiffness", 3e6, 1e-9}}, angle};
  for (std::size_t i = 0; i < stiffnesses.size(); ++i) {
    reference.numbers.push_back({i + 1, "break_frequency", break_frequencies[i], frequency_tolerance});
    reference.numbers.push_back({i + 1, "stiffness", stiffnesses[i] * 1e6, 0.00005e6});
  }
  return reference;
}

const std::vector<Reference> kReferences = {
    {"KelvinVoigt",
     Model::kelvin_voigt,
     {{"dynamic_stiffness", 4.2e6}, {"nominal_frequency", 4.0}, {"relative_damping", 0.05}},
     {{0, "stiffness", 4.2e6, 1e-9}, {1, "damping", 0.01671e6, 0.000005e6}}},
    byBreakFrequency("MaxwellAtHalfAHertz", 0.5, 1.2160, 2.04),
    byBreakFrequency("MaxwellAt1Hertz", 1.0, 1.2638, 4.06),
    byBreakFrequency("MaxwellAt2Hertz", 2.0, 1.4497, 7.94),
    byBreakFrequency("MaxwellAt4Hertz", 4.0, 2.1264, 14.66),
    byBreakFrequency("MaxwellAt8Hertz", 8.0, 4.2250, 23.73),
    byLossAngle("MaxwellByDamping", "relative_damping", 0.05, 1.4177, 1.32727e6),
    byLossAngle("MaxwellByRoundedAngle", "loss_angle", 5.7 * element::kPi / 180.0, 1.4150, 1.32679e6),
    byLossAngle("MaxwellByLossEnergy", "loss_angle", std::asin(2.0 * 0.05), 1.4250, 1.3286e6),
    {"MaxwellDashpot",
     Model::maxwell_dashpot,
     kExample + Values{{"break_frequency", 0.5}, {"relative_damping", 0.05}},
     {{1, "stiffness", 1.198e6, 0.0005e6}, {2, "damping", 0.01076e6, 0.000005e6}}},
    {"Friction",
     Model::friction,
     kFrictionExample,
     {{1, "maximum_force", 6047.5, 0.05}, {1, "displacement", 2.1760e-3, 0.00005e-3}}},
    {"FrictionDashpot",
     Model::friction_dashpot,
     kFrictionExample,
     {{1, "maximum_force", 7470.0, 0.05}, {1, "displacement", 3.1976e-3, 0.00005e-3}, {2, "damping", 3326.0, 0.5}}},
    {"Berg",
     Model::berg,
     with(kFrictionExample, "break_frequency", 1.45),
     {{1, "maximum_force", 4920.9, 0.05},
      {1, "displacement", 2.2109e-3, 0.00005e-3},
      {2, "stiffness", 0.26087e6, 0.000005e6}}},
    bank("MultiMaxwellThree", kThreeElements, {1.582, 5.091, 16.384}, 0.0005, {1.0573, 0.5532, 0.2895}, 9.55),
    bank("MultiMaxwellFive", kFiveInputs, {0.0348, 0.1593, 0.7284, 3.3311, 15.2334}, 0.00005,
         {0.2334, 0.2908, 0.3623, 0.4513, 0.5622}, 5.98)};

class ReferenceValues : public testing::TestWithParam<Reference> {};
INSTANTIATE_TEST_SUITE_P(OfThePaper, ReferenceValues, testing::ValuesIn(kReferences),
                         [](const auto& test) { return test.param.name; });

TEST_P(ReferenceValues, AreThoseOfTheEstimation) {
  const auto elements = estimated(GetParam().model, GetParam().values);
  for (const Number& number : GetParam().numbers) {
    ASSERT_LT(number.element, elements.size());
    EXPECT_NEAR(elements[number.element].value(number.key), number.value, number.tolerance)
        << number.key << " of element " << number.element;
  }
  if (GetParam().angle != 0.0) {
    EXPECT_NEAR(degreesOf(stiffness(elements, 4.0)), GetParam().angle, 0.005);
  }
}

// Ratios of neighbouring Maxwell elements, and the damping k_1/(2 pi f_b) of Berg's model.
TEST(ReferenceRatios, AreThoseOfTheEstimation) {
  const auto three = estimated(Model::multi_maxwell, kThreeElements);
  EXPECT_NEAR(three[1].value("stiffness") / three[2].value("stiffness"), 1.911, 0.0005);
  const auto five = estimated(Model::multi_maxwell, kFiveInputs);
  EXPECT_NEAR(five[1].value("stiffness") / five[2].value("stiffness"), 0.8027, 0.00005);
  EXPECT_EQ(three.size(), 4U);
  EXPECT_EQ(five.size(), 6U);
  const auto berg = estimated(Model::berg, with(kFrictionExample, "break_frequency", 1.45));
  EXPECT_NEAR(berg[2].value("stiffness") / (2.0 * element::kPi * berg[2].value("break_frequency")), 0.02863e6,
              0.000005e6);
}

TEST(ReferenceCurves, MultiMaxwellOverFrequency) {
  const double frequencies[] = {0.5, 1, 2, 4, 8, 12, 20};
  const struct {
    Values values;
    double stiffness[7], angle[7];
  } models[] = {
      {kThreeElements, {3.12, 3.38, 3.80, 4.20, 4.50, 4.63, 4.76}, {6.74, 10.2, 11.2, 9.55, 7.22, 5.87, 4.31}},
      {kFiveInputs, {3.64, 3.81, 3.99, 4.20, 4.41, 4.54, 4.69}, {5.58, 5.82, 5.97, 5.98, 5.61, 5.26, 4.40}}};
  for (const auto& model : models) {
    const auto elements = estimated(Model::multi_maxwell, model.values);
    for (int i = 0; i < 7; ++i) {
      const auto k = stiffness(elements, frequencies[i]);
      EXPECT_NEAR(std::abs(k), model.stiffness[i] * 1e6, 0.005e6) << frequencies[i];
      EXPECT_NEAR(degreesOf(k), model.angle[i], model.angle[i] >= 10.0 ? 0.05 : 0.005) << frequencies[i];
    }
  }
}

TEST(ReferenceCurves, MaxwellAtTwentyHertz) {
  const auto elements = estimated(Model::maxwell, with(kExample, "break_frequency", 1.43));
  EXPECT_NEAR(std::abs(stiffness(elements, 20.0)), 4.32e6, 0.005e6);
}

}  // namespace
}  // namespace rubber_suspension
