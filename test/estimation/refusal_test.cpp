// Specifications without a solution are refused with key, value and accepted intervals.
#include <regex>

#include "estimation/values.h"
#include "rubber_suspension/element/constants.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

const Values kFiveInputs = {{"static_stiffness", 3e6},
                            {"dynamic_stiffness", 4.2e6},
                            {"nominal_frequency", 4.0},
                            {"maximum_stiffness", 4.9e6},
                            {"high_frequency", 25.0}};
const Values kFriction = {{"static_stiffness", 3e6},
                          {"dynamic_stiffness", 4.2e6},
                          {"nominal_frequency", 4.0},
                          {"nominal_amplitude", 2e-3},
                          {"relative_damping", 0.05}};
const Values kMaxwell = {
    {"static_stiffness", 3e6}, {"dynamic_stiffness", 4.2e6}, {"nominal_frequency", 4.0}, {"loss_angle", 0.1}};
const Values kKelvinVoigt = {{"dynamic_stiffness", 4.2e6}, {"nominal_frequency", 4.0}, {"loss_angle", 0.1}};

const Values kBerg = with(kFriction, "break_frequency", 1.45);
const Values kMaxwellDashpot = with(kMaxwell, "break_frequency", 0.5);

std::string refusal(estimation::Model model, const Values& values) {
  return messageOf<std::invalid_argument>(
      [&] { estimation::estimate(model, specificationOf(values, estimation::Describes::unsaid)); });
}

bool solvable(estimation::Model model, const Values& values) { return refusal(model, values) == ""; }

TEST(Refusal, SlipsOfInput) {
  const struct {
    estimation::Model model;
    const Values* values;
    std::string key;
    double value;
  } rows[] = {
      {estimation::Model::multi_maxwell, &kFiveInputs, "static_stiffness", 30e6},
      {estimation::Model::multi_maxwell, &kFiveInputs, "static_stiffness", 0.3e6},
      {estimation::Model::multi_maxwell, &kFiveInputs, "static_stiffness", 3.0},
      {estimation::Model::multi_maxwell, &kFiveInputs, "static_stiffness", -3e6},
      {estimation::Model::multi_maxwell, &kFiveInputs, "dynamic_stiffness", 42e6},
      {estimation::Model::multi_maxwell, &kFiveInputs, "dynamic_stiffness", 2.4e6},
      {estimation::Model::multi_maxwell, &kFiveInputs, "dynamic_stiffness", 4.9e6},
      {estimation::Model::multi_maxwell, &kFiveInputs, "dynamic_stiffness", 3e6},
      {estimation::Model::multi_maxwell, &kFiveInputs, "dynamic_stiffness", NAN},
      {estimation::Model::multi_maxwell, &kFiveInputs, "maximum_stiffness", 49e6},
      {estimation::Model::multi_maxwell, &kFiveInputs, "maximum_stiffness", 0.49e6},
      {estimation::Model::multi_maxwell, &kFiveInputs, "nominal_frequency", 40.0},
      {estimation::Model::multi_maxwell, &kFiveInputs, "high_frequency", 2.5},
      {estimation::Model::multi_maxwell, &kFiveInputs, "low_frequency", 25.0},
      {estimation::Model::multi_maxwell, &kFiveInputs, "low_frequency", 4.0},
      {estimation::Model::multi_maxwell, &kFiveInputs, "maxwell_elements", 1.0},
      {estimation::Model::multi_maxwell, &kFiveInputs, "maxwell_elements", 2.0},
      {estimation::Model::multi_maxwell, &kFiveInputs, "maxwell_elements", 3.5},
      {estimation::Model::multi_maxwell, &kFiveInputs, "maxwell_elements", 50.0},
      {estimation::Model::multi_maxwell, &kFiveInputs, "loss_angle", 0.1},  // one input too many
      {estimation::Model::multi_maxwell, &kFiveInputs, "break_frequency", 1.0},
      {estimation::Model::multi_maxwell, &kFiveInputs, "dynamic_stifness", 4.2e6},
      {estimation::Model::maxwell, &kMaxwell, "dynamic_stiffness", 2e6},
      {estimation::Model::maxwell, &kMaxwell, "loss_angle", 5.7},
      {estimation::Model::maxwell, &kMaxwell, "loss_angle", 1.0},
      {estimation::Model::maxwell, &kMaxwell, "loss_angle", element::kPi / 2.0},
      {estimation::Model::maxwell, &kMaxwell, "loss_angle", 0.0},
      {estimation::Model::maxwell, &kMaxwell, "break_frequency", 1.0},  // in addition to the loss angle
      {estimation::Model::maxwell, &kMaxwell, "nominal_frequency", 0.0},
      {estimation::Model::maxwell, &kMaxwell, "nominal_frequency", HUGE_VAL},
      {estimation::Model::maxwell_dashpot, &kMaxwellDashpot, "break_frequency", 5.0},
      {estimation::Model::kelvin_voigt, &kKelvinVoigt, "relative_damping", 0.05},
      {estimation::Model::kelvin_voigt, &kKelvinVoigt, "loss_angle", 1.6},
      {estimation::Model::kelvin_voigt, &kKelvinVoigt, "static_stiffness", 5e6},
      {estimation::Model::kelvin_voigt, &kKelvinVoigt, "dynamic_stiffness", -1.0},
      {estimation::Model::friction, &kFriction, "relative_damping", 5.0},
      {estimation::Model::friction, &kFriction, "relative_damping", 0.5},
      {estimation::Model::friction, &kFriction, "nominal_amplitude", 2.0},
      {estimation::Model::friction, &kFriction, "viscous_share", 0.2},
      {estimation::Model::friction_dashpot, &kFriction, "viscous_share", 20.0},
      {estimation::Model::friction_dashpot, &kFriction, "viscous_share", 1.0},
      {estimation::Model::friction_dashpot, &kFriction, "dynamic_stiffness", 3.1e6},
      {estimation::Model::berg, &kBerg, "break_frequency", 0.02},
      {estimation::Model::berg, &kBerg, "dynamic_stiffness", 2.9e6},
      {estimation::Model::berg, &kBerg, "dynamic_stiffness", 3.2e6},
  };
  for (const auto& row : rows) {
    ASSERT_TRUE(solvable(row.model, *row.values)) << estimation::toString(row.model);
    const std::string message = refusal(row.model, with(*row.values, row.key, row.value));
    EXPECT_THAT(message, HasSubstr(row.key)) << row.key << " = " << row.value;
    EXPECT_THAT(message, HasSubstr("accepted")) << row.key;
    EXPECT_THAT(message, ::testing::Not(HasSubstr("\n")));
    EXPECT_NE(message, "") << row.key << " = " << row.value;
  }
}

TEST(Refusal, MissingInputs) {
  const std::pair<estimation::Model, Values> complete[] = {
      {estimation::Model::kelvin_voigt, kKelvinVoigt},       {estimation::Model::maxwell, kMaxwell},
      {estimation::Model::maxwell_dashpot, kMaxwellDashpot}, {estimation::Model::friction, kFriction},
      {estimation::Model::friction_dashpot, kFriction},      {estimation::Model::berg, kBerg},
      {estimation::Model::multi_maxwell, kFiveInputs}};
  for (const auto& [model, values] : complete) {
    for (const auto& [key, value] : values) {
      EXPECT_THAT(refusal(model, without(values, key)), HasSubstr(key)) << estimation::toString(model);
    }
  }
}

TEST(Refusal, ElementsTakeNoSpecification) {
  EXPECT_TRUE(solvable(estimation::Model::elements, {}));
  EXPECT_THAT(refusal(estimation::Model::elements, {{"static_stiffness", 3e6}}), HasSubstr("static_stiffness"));
}

struct Interval {
  std::string key;
  double lower;
  double upper;
};

// Returns true if the specification that a message states as nearest has a solution.
bool nearestIsSolvable(estimation::Model model, const std::string& message) {
  const std::string before = "nearest: specification: ";
  const std::size_t place = message.find(before);
  const std::string nearest = place == std::string::npos ? "{}" : message.substr(place + before.size());
  return messageOf<std::exception>([&] {
           componentOf("components: {b: {model: " + toString(model) + ", specification: " + nearest + "}}");
         }) == "";
}

// Parses all intervals "key in (a, b)" of a message, including those behind "or".
std::vector<Interval> intervalsIn(const std::string& message) {
  std::vector<Interval> intervals;
  const std::string text = message.substr(message.find("accepted: "));
  const std::regex pattern(R"((?:([a-z_]+) |or )in [(\[]([-+.e0-9]+), ([-+.e0-9]+)[)\]])");
  std::string key;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), pattern); it != std::sregex_iterator(); ++it) {
    key = (*it)[1].matched && (*it)[1] != "or" ? (*it)[1].str() : key;
    intervals.push_back({key, std::stod((*it)[2]), std::stod((*it)[3])});
  }
  return intervals;
}

TEST(Refusal, NamesTheIntervalOfTheDynamicStiffness) {
  const Values values = with(kFiveInputs, "maxwell_elements", 2.0);
  const std::string message = refusal(estimation::Model::multi_maxwell, values);
  EXPECT_THAT(message, HasSubstr("dynamic_stiffness: 4.2e+06 N/m"));
  // At the bounds, only the last or only the first element has stiffness. The elements' bands have the edges 5, 5
  // sqrt(5) and 25 Hz. Each break frequency is the mean of two edges.
  const auto single = [](double break_frequency) {
    const std::complex<double> ratio(0.0, 4.0 / break_frequency);
    return std::abs(3e6 + 1.9e6 * ratio / (1.0 + ratio));
  };
  const double lower = single(0.5 * (5.0 * std::sqrt(5.0) + 25.0));
  const double upper = single(0.5 * (5.0 + 5.0 * std::sqrt(5.0)));
  for (const Interval& interval : intervalsIn(message)) {
    if (interval.key == "dynamic_stiffness") {
      EXPECT_NEAR(interval.lower / lower, 1.0, 1e-5);  // six digits are printed
      EXPECT_NEAR(interval.upper / upper, 1.0, 1e-5);
      return;
    }
  }
  FAIL() << message;
}

TEST(Refusal, EveryIntervalNamedHoldsSolutions) {
  const std::pair<estimation::Model, Values> unsolvable[] = {
      {estimation::Model::multi_maxwell, with(kFiveInputs, "maxwell_elements", 2.0)},
      {estimation::Model::multi_maxwell, with(kFiveInputs, "dynamic_stiffness", 4.8999e6)},
      {estimation::Model::multi_maxwell, with(without(kFiveInputs, "maximum_stiffness"), "loss_angle", 0.7)},
      {estimation::Model::multi_maxwell, with(without(kFiveInputs, "high_frequency"), "loss_angle", 0.02)},
      {estimation::Model::maxwell, with(kMaxwell, "loss_angle", 1.0)},
      {estimation::Model::maxwell_dashpot, with(kMaxwellDashpot, "break_frequency", 5.0)},
      {estimation::Model::friction, with(kFriction, "relative_damping", 0.5)},
      {estimation::Model::friction_dashpot, with(kFriction, "dynamic_stiffness", 3.1e6)},
      {estimation::Model::berg, with(kBerg, "dynamic_stiffness", 3.2e6)},
      {estimation::Model::berg, with(kBerg, "break_frequency", 0.02)},
  };
  for (const auto& [model, values] : unsolvable) {
    const std::string message = refusal(model, values);
    ASSERT_NE(message, "") << estimation::toString(model);
    EXPECT_TRUE(nearestIsSolvable(model, message)) << message;
    const auto intervals = intervalsIn(message);
    EXPECT_FALSE(intervals.empty()) << message;
    for (const Interval& interval : intervals) {
      if (interval.key == "maxwell_elements") {
        continue;  // must be an integer
      }
      const double width = interval.upper - interval.lower;
      for (const double part : {0.001, 0.5, 0.999}) {
        EXPECT_TRUE(solvable(model, with(values, interval.key, interval.lower + part * width)))
            << interval.key << " in (" << interval.lower << ", " << interval.upper << ") of: " << message;
      }
      for (const double beyond : {interval.lower - 0.001 * width, interval.upper + 0.001 * width}) {
        EXPECT_FALSE(solvable(model, with(values, interval.key, beyond))) << interval.key << " " << beyond << message;
      }
    }
  }
}

// If no change of a single input is sufficient, two inputs have to change.
TEST(Refusal, TellsWhatIsNearestToOneStiffnessThroughout) {
  const Values values = with(with(kFiveInputs, "dynamic_stiffness", 3e6), "maximum_stiffness", 3e6);
  const std::string message = refusal(estimation::Model::multi_maxwell, values);
  EXPECT_THAT(message, HasSubstr("accepted: no value of any single input with the others unchanged; nearest: "));
  EXPECT_TRUE(nearestIsSolvable(estimation::Model::multi_maxwell, message)) << message;
}

TEST(Tables, EveryKeyOfEveryModelIsInTheTable) {
  for (const estimation::Model model :
       {estimation::Model::kelvin_voigt, estimation::Model::maxwell, estimation::Model::maxwell_dashpot,
        estimation::Model::friction, estimation::Model::friction_dashpot, estimation::Model::berg,
        estimation::Model::multi_maxwell, estimation::Model::elements}) {
    EXPECT_EQ(estimation::modelFromString(estimation::toString(model)), model);
    const estimation::ModelInfo& info = estimation::modelInfo(model);
    EXPECT_EQ(info.model, model);
    std::vector<std::string> keys = info.required;
    keys.insert(keys.end(), info.optional.begin(), info.optional.end());
    for (const auto& groups : {info.one_of, info.two_of}) {
      for (const auto& group : groups) {
        keys.insert(keys.end(), group.begin(), group.end());
      }
    }
    for (const std::string& key : keys) {
      const auto& table = estimation::specificationParameters();
      EXPECT_EQ(
          std::count_if(table.begin(), table.end(), [&](const element::ParameterInfo& row) { return row.name == key; }),
          1)
          << key;
    }
  }
  EXPECT_FALSE(estimation::modelFromString("kelvin").has_value());
}

}  // namespace
}  // namespace rubber_suspension
