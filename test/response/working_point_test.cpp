// At the working point, the loop of every model has the specified values, for random specifications.
#include "estimation/values.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/response/sweep.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

using estimation::Model;
using estimation::Specification;

constexpr int kSpecifications = 300;

std::mt19937 generator;

double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }
double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

double angleOf(const Values& values) {
  return values.count("loss_angle") != 0 ? values.at("loss_angle") : std::atan(2.0 * values.at("relative_damping"));
}

void addAngle(Values& values, double largest) {
  const double angle = uniform(0.005, largest);
  const bool as_angle = uniform(0.0, 1.0) < 0.5;
  values[as_angle ? "loss_angle" : "relative_damping"] = as_angle ? angle : 0.5 * std::tan(angle);
}

// Returns the largest loss angle at which the storage stiffness is larger than the static stiffness.
double storageLimit(const Values& values) {
  return std::acos(values.at("static_stiffness") / values.at("dynamic_stiffness"));
}

// Returns the loss angle at the largest loss stiffness of friction: 4/pi of the stiffness of Coulomb friction.
double frictionLimit(const Values& values) {
  const double ratio = values.at("static_stiffness") / values.at("dynamic_stiffness");
  return std::asin(std::min(0.95, 4.0 / element::kPi * (1.0 - ratio)));
}

// Draws the five inputs of multi_maxwell until they have a solution.
void makeFiveInputs(Values& values) {
  const Values first = values;
  while (true) {
    values = first;
    values["maximum_stiffness"] = values["dynamic_stiffness"] * uniform(1.01, 2.0);
    values["high_frequency"] = values["nominal_frequency"] * logUniform(1.5, 50.0);
    values["maxwell_elements"] = std::floor(uniform(3.0, 9.0));
    try {
      estimated(Model::multi_maxwell, values);
      return;
    } catch (const std::invalid_argument&) {
      // Tests of refusals check these errors.
    }
  }
}

response::SweepPoint atWorkingPoint(const Entries& elements, const Values& values) {
  const auto amplitude = values.find("nominal_amplitude");
  return response::characteristicsAt(component::Component(elements), values.at("nominal_frequency"),
                                     amplitude == values.end() ? 1e-3 : amplitude->second);
}

// Replaces one of five inputs by the loss angle that they give.
void setAngleFor(Values& values, const std::string& replaced) {
  const Entries five = estimated(Model::multi_maxwell, values);
  values["loss_angle"] = atWorkingPoint(five, values).characteristics.loss_angle;
  values.erase(replaced);
}

double sumOfStiffnesses(const Entries& elements) {
  double sum = 0.0;
  for (const element::ElementDescription& element : elements) {
    sum += element.value("stiffness");
  }
  return sum;
}

struct Kind {
  std::string name;
  Model model;
  std::function<void(Values&)> complete;  // adds the other values that the model needs
  double accuracy;                        // relative, for stiffness, loss angle and maximum stiffness
  std::string replaced = "";              // input that the loss angle replaces
  int unsolved = 0;                       // percentage of specifications that may have no solution
};

constexpr double kLinear = 1e-9;
constexpr double kFriction = 1e-6;

const std::vector<Kind> kKinds = {
    {"MaxwellByBreakFrequency", Model::maxwell,
     [](Values& v) { v["break_frequency"] = v["nominal_frequency"] * logUniform(1e-3, 30.0); }, kLinear},
    {"MaxwellByLossAngle", Model::maxwell, [](Values& v) { addAngle(v, 0.95 * storageLimit(v)); }, kLinear},
    {"MaxwellByMaximumStiffness", Model::maxwell,
     [](Values& v) { v["maximum_stiffness"] = v["dynamic_stiffness"] * uniform(1.01, 3.0); }, kLinear},
    {"MaxwellDashpot", Model::maxwell_dashpot,
     [](Values& v) {
       addAngle(v, 0.9 * storageLimit(v));
       const double k = v["dynamic_stiffness"];
       const double limit =
           v["nominal_frequency"] * k * std::sin(angleOf(v)) / (k * std::cos(angleOf(v)) - v["static_stiffness"]);
       v["break_frequency"] = limit * logUniform(1e-3, 0.99);
     },
     kLinear},
    {"Friction", Model::friction,
     [](Values& v) {
       v["nominal_amplitude"] = logUniform(1e-5, 0.1);
       addAngle(v, 0.95 * frictionLimit(v));
     },
     kFriction},
    {"Berg", Model::berg,
     [](Values& v) {
       v["nominal_amplitude"] = logUniform(1e-5, 0.1);
       v["viscous_share"] = uniform(0.0, 0.3);
       v["break_frequency"] = v["nominal_frequency"] * logUniform(0.3, 3.0);
       addAngle(v, 0.4 * frictionLimit(v));
     },
     kFriction},
    {"MultiMaxwell", Model::multi_maxwell, makeFiveInputs, kLinear},
    {"MultiMaxwellWithLossAngleForMaximumStiffness", Model::multi_maxwell, makeFiveInputs, kLinear,
     "maximum_stiffness"},
    // Near the lowest possible loss angle, the scan misses pairs of solutions that are closer than its step.
    {"MultiMaxwellWithLossAngleForHighFrequency", Model::multi_maxwell, makeFiveInputs, kLinear, "high_frequency", 10}};

// Draws specifications of rubber springs of all sizes.
Values anyValues() {
  const double k_st = logUniform(1e4, 1e8);
  const double k_n = k_st * uniform(1.02, 2.5);
  return {{"static_stiffness", k_st}, {"dynamic_stiffness", k_n}, {"nominal_frequency", logUniform(0.1, 50.0)}};
}

class WorkingPoint : public testing::TestWithParam<Kind> {
 protected:
  WorkingPoint() { generator.seed(20150801); }
};

INSTANTIATE_TEST_SUITE_P(OfEveryModel, WorkingPoint, testing::ValuesIn(kKinds),
                         [](const auto& test) { return test.param.name; });

TEST_P(WorkingPoint, IsWhatWasSpecified) {
  int solved = 0;
  for (int i = 0; i < kSpecifications; ++i) {
    Values values = anyValues();
    GetParam().complete(values);
    const Values given = values;
    if (!GetParam().replaced.empty()) {
      setAngleFor(values, GetParam().replaced);
    }
    Entries elements;
    try {
      elements = estimated(GetParam().model, values);
    } catch (const std::invalid_argument& error) {
      ASSERT_GT(GetParam().unsolved, 0) << error.what();
      continue;
    }
    ++solved;
    EXPECT_EQ(elements.at(0).type, "spring");
    EXPECT_EQ(elements.at(0).value("stiffness"), values["static_stiffness"]);
    const response::SweepPoint point = atWorkingPoint(elements, values);
    EXPECT_TRUE(point.settled);
    EXPECT_NEAR(point.characteristics.stiffness / values["dynamic_stiffness"], 1.0, GetParam().accuracy);
    if (values.count("loss_angle") + values.count("relative_damping") != 0) {
      EXPECT_NEAR(point.characteristics.loss_angle / angleOf(values), 1.0, GetParam().accuracy);
    }
    if (given.count("maximum_stiffness") != 0) {
      // A replaced maximum stiffness is found again, less exactly if one element has nearly all of it.
      const double accuracy = values.count("maximum_stiffness") != 0 ? GetParam().accuracy : 1e-6;
      EXPECT_NEAR(sumOfStiffnesses(elements) / given.at("maximum_stiffness"), 1.0, accuracy);
    }
  }
  EXPECT_GE(solved, kSpecifications * (100 - GetParam().unsolved) / 100);
}

// For the Kelvin-Voigt model (M1), K_n is the storage stiffness (Eq. 11) instead of the magnitude of K*.
TEST(WorkingPointOfKelvinVoigt, HasTheStorageStiffness) {
  generator.seed(20150801);
  for (int i = 0; i < kSpecifications; ++i) {
    Values values = anyValues();
    addAngle(values, 0.8);
    const component::Component component(estimated(Model::kelvin_voigt, values));
    const auto k = component.complexStiffness(values["nominal_frequency"]).value();
    EXPECT_NEAR(k.real() / values["dynamic_stiffness"], 1.0, kLinear);
    EXPECT_NEAR(std::arg(k) / angleOf(values), 1.0, kLinear);
  }
}

// K_n applies between the turning points. The loss is that of a loop with K_n and the loss angle.
TEST(WorkingPointOfFrictionDashpot, HoldsBetweenTheTurningPoints) {
  generator.seed(20150801);
  for (int i = 0; i < kSpecifications; ++i) {
    Values values = anyValues();
    const double amplitude = values["nominal_amplitude"] = logUniform(1e-5, 0.1);
    values["viscous_share"] = uniform(0.0, 0.5);
    addAngle(values, 0.95 * frictionLimit(values));
    const component::Component component(estimated(Model::friction_dashpot, values));
    const auto loop = response::simulateSettledLoop(component, values["nominal_frequency"], amplitude);
    const double between = (loop.force[loop.force.size() / 2] - loop.force[0]) / (2.0 * amplitude);
    EXPECT_NEAR(between / values["dynamic_stiffness"], 1.0, kFriction);
    const double loss = element::kPi * values["dynamic_stiffness"] * amplitude * amplitude;
    EXPECT_NEAR(loop.characteristics().loss / (loss * std::sin(angleOf(values))), 1.0, kFriction);
  }
}

// The solution is unique, so the loss angle leads to the same elements again.
TEST(MultiMaxwell, InputsOfTheExampleComeBackFromTheirLossAngle) {
  const Values inputs = {{"static_stiffness", 3e6},
                         {"dynamic_stiffness", 4.2e6},
                         {"nominal_frequency", 4.0},
                         {"maximum_stiffness", 4.9e6},
                         {"high_frequency", 25.0}};
  const Entries five = estimated(Model::multi_maxwell, inputs);
  for (const char* replaced : {"high_frequency", "maximum_stiffness"}) {
    Values values = inputs;
    setAngleFor(values, replaced);
    const Entries elements = estimated(Model::multi_maxwell, values);
    for (std::size_t i = 1; i < five.size(); ++i) {
      EXPECT_NEAR(elements[i].value("break_frequency") / five[i].value("break_frequency"), 1.0, 1e-9) << replaced;
      EXPECT_NEAR(elements[i].value("stiffness") / five[i].value("stiffness"), 1.0, 1e-9) << replaced;
    }
  }
}

}  // namespace
}  // namespace rubber_suspension
