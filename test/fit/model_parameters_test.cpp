// Model parameters as unknowns: what the user would have to write.
#include "fit/model_parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

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
      far[i] = std::log(1e-3);  // the high frequency falls below the nominal one
    }
  }
  ASSERT_FALSE(model.elements(far).has_value());
  std::map<std::string, double> ratios;
  for (const auto& [key, ratio] : model.ratios(far)) {
    ratios[key] = ratio;
  }
  EXPECT_NEAR(ratios.at("high_frequency"), 1e-3, 1e-9);  // proportional to the fastest break frequency
  EXPECT_GT(ratios.at("dynamic_stiffness"), 1.0);        // all relaxes below the nominal frequency
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

}  // namespace
}  // namespace rubber_suspension::fit
