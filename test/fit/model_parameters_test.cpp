// Parameters of the fit, and the corresponding numbers of the data sheet.
#include "fit/model_parameters.h"

#include "support/kit.h"

namespace rubber_suspension::fit {
namespace {

io::ComponentDescription multiMaxwell() {
  estimation::Specification specification;
  for (const auto& [key, value] : std::map<std::string, double>{{"static_stiffness", 1e6},
                                                                {"dynamic_stiffness", 1.3e6},
                                                                {"nominal_frequency", 5.0},
                                                                {"maximum_stiffness", 2e6},
                                                                {"high_frequency", 200.0}}) {
    specification.set(key, value);
  }
  return {"bush", estimation::Model::multi_maxwell, specification};
}

TEST(ModelParameters, GivesRatiosWhereNoComponentHasThem) {
  const ModelParameters model(multiMaxwell(), Level::specification);
  Eigen::VectorXd far = Eigen::VectorXd::Zero(model.size());
  for (Eigen::Index i = 0; i < model.size(); ++i) {
    if (model.names()[static_cast<std::size_t>(i)] == "break_frequency") {
      far[i] = std::log(1e-3);  // the high frequency falls below the nominal frequency
    }
  }
  ASSERT_FALSE(model.elements(far).has_value());
  std::map<std::string, double> ratios;
  for (const auto& [key, ratio] : model.ratios(far)) {
    ratios[key] = ratio;
  }
  EXPECT_NEAR(ratios.at("high_frequency"), 1e-3, 1e-9);  // proportional to the fastest break frequency
  EXPECT_GT(ratios.at("dynamic_stiffness"), 1.0);        // all elements relax below the nominal frequency
  EXPECT_EQ(ratios.count("static_stiffness"), 0u);
}

TEST(ModelParameters, GivesTheRatiosOfAComponentThatIs) {
  const ModelParameters model(multiMaxwell(), Level::specification);
  const Eigen::VectorXd near = Eigen::VectorXd::Constant(model.size(), 0.05);
  const estimation::Specification moved = model.apply(near).specification();
  const estimation::Specification before = multiMaxwell().specification();
  for (const auto& [key, ratio] : model.ratios(near)) {
    EXPECT_DOUBLE_EQ(ratio, moved.at(key) / before.at(key)) << key;
  }
  EXPECT_TRUE(model.ratios(Eigen::VectorXd::Zero(model.size())).empty());
}

// The fitted component states a break frequency in place of these numbers, but the data sheet is off all the same.
TEST(ModelParameters, GiveTheRatiosOfNumbersThatTheFittedComponentDoesNotState) {
  const auto keysMovedBy = [](estimation::Model kind, const estimation::Specification& sheet, double logarithm) {
    const ModelParameters model(io::ComponentDescription("bush", kind, sheet), Level::specification);
    std::set<std::string> keys;
    for (const auto& [key, ratio] : model.ratios(Eigen::VectorXd::Constant(model.size(), logarithm))) {
      keys.insert(key);
    }
    return keys;
  };
  estimation::Specification sheet;
  sheet.set("static_stiffness", 1e6);
  sheet.set("dynamic_stiffness", 1.3e6);
  sheet.set("nominal_frequency", 5.0);
  sheet.set("maximum_stiffness", 1.5e6);
  EXPECT_EQ(keysMovedBy(estimation::Model::maxwell, sheet, 0.05).count("maximum_stiffness"), 1U);
  EXPECT_THAT(keysMovedBy(estimation::Model::maxwell, sheet, 0.0), IsEmpty());
  sheet.erase("maximum_stiffness");
  sheet.set("break_frequency", 8.0);
  sheet.set("relative_damping", 0.2);
  EXPECT_EQ(keysMovedBy(estimation::Model::maxwell_dashpot, sheet, 0.05).count("relative_damping"), 1U);
  EXPECT_THAT(keysMovedBy(estimation::Model::maxwell_dashpot, sheet, 0.0), IsEmpty());
}

// Departures are deviations from the data sheet in units of its tolerance. They are zero for the configured component.
TEST(ModelParameters, DepartFromTheSheetInTolerances) {
  estimation::Specification sheet = multiMaxwell().specification();
  sheet.setTolerance({0.2, {{"dynamic_stiffness", 0.05}}});
  io::ComponentDescription bush("bush", estimation::Model::multi_maxwell, sheet);
  bush.add = {spring(1e5)};
  const ModelParameters model(bush, Level::specification);
  EXPECT_TRUE(model.departures(Eigen::VectorXd::Zero(model.size())).isZero(0.0));
  const Eigen::VectorXd near = Eigen::VectorXd::LinSpaced(model.size(), -0.1, 0.2);
  const Eigen::VectorXd departures = model.departures(near);
  std::map<std::string, double> ratios;
  for (const auto& [key, ratio] : model.ratios(near)) {
    ratios[key] = ratio;
  }
  ASSERT_EQ(model.known().size(), 5U);  // four from the data sheet, and the added spring
  for (std::size_t i = 0; i < 4; ++i) {
    const KnownNumber& number = model.known()[i];
    EXPECT_NEAR(departures[static_cast<Eigen::Index>(i)],
                std::log(ratios.at(number.name)) / (number.name == "dynamic_stiffness" ? 0.05 : 0.2), 1e-9)
        << number.name;
  }
  EXPECT_NEAR(departures[4], near[model.size() - 1] / model.known()[4].deviation, 1e-12);
  const Eigen::VectorXd step = Eigen::VectorXd::Constant(model.size(), 1e-4);
  EXPECT_TRUE((departures + model.departureSlopes(near) * step).isApprox(model.departures(near + step), 1e-5));
}

TEST(ModelParameters, OfElementsHaveTheirTolerances) {
  io::ComponentDescription component("damper", {{"spring", {{"stiffness", {1e6}}}}, {"dashpot", {{"damping", {2e3}}}}});
  const auto deviations = [](const ModelParameters& model) {
    return std::vector<double>{model.known()[0].deviation, model.known()[1].deviation};
  };
  const ModelParameters usual(component, Level::elements);
  EXPECT_EQ(deviations(usual), std::vector<double>(2, 0.3));
  component.tolerance.by_key["dashpot[1]"] = 0.05;
  EXPECT_EQ(deviations({component, Level::elements}), (std::vector<double>{0.3, 0.05}));
  component.tolerance = {estimation::SheetTolerance::kGuess};
  const ModelParameters guess(component, Level::specification);
  EXPECT_TRUE(guess.isGuess());
  EXPECT_FALSE(usual.isGuess());
  component.add = {{"spring", {{"stiffness", {1e5}}}}};  // an added element is not part of a guess
  const ModelParameters with_added(component, Level::specification);
  EXPECT_TRUE(with_added.isGuess());
  EXPECT_EQ(with_added.known().back().deviation, 0.3);
  EXPECT_NEAR(guess.bounds()[0], 2.0 * std::log(10.0), 1e-12) << "two deviations";
  EXPECT_NEAR(usual.bounds()[0], std::log(10.0), 1e-12);
}

// Some data sheets define one stiffness by another, for example that of one Maxwell element at the high frequency.
TEST(ModelParameters, DepartFromEveryNumberThatASheetMayState) {
  for (const auto& [key, value] : std::map<std::string, double>{
           {"maximum_stiffness", 1.5e6}, {"loss_angle", 0.1}, {"relative_damping", 0.05}, {"break_frequency", 7.0}}) {
    estimation::Specification sheet;
    sheet.set("static_stiffness", 1e6);
    sheet.set("dynamic_stiffness", 1.3e6);
    sheet.set("nominal_frequency", 5.0);
    sheet.set(key, value);
    const ModelParameters model({"bush", estimation::Model::maxwell, sheet}, Level::specification);
    const Eigen::VectorXd far = Eigen::VectorXd::Constant(model.size(), 0.3);
    EXPECT_EQ(model.known().size(), 3U) << key;
    EXPECT_TRUE(model.departures(Eigen::VectorXd::Zero(model.size())).isZero(0.0)) << key;
    EXPECT_GT(model.departures(far).norm(), 1.0) << key;
    EXPECT_FALSE(model.isGuess());
  }
}

}  // namespace
}  // namespace rubber_suspension::fit
