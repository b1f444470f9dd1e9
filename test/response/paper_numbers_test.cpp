// Stiffness and loss angle of the paper's models away from the working point, to the digits of the paper.
#include "estimation/values.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/response/sweep.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr double kProduct = 8e-3;  // [m Hz]

component::Component frictionModel(estimation::Model model) {
  Values values = {{"static_stiffness", 3e6},
                   {"dynamic_stiffness", 4.2e6},
                   {"nominal_frequency", 4.0},
                   {"nominal_amplitude", 2e-3},
                   {"relative_damping", 0.05}};
  if (model == estimation::Model::berg) {
    values["break_frequency"] = 1.45;
  }
  return component::Component(estimated(model, values));
}

TEST(PaperNumbers, StiffnessAtTwentyHertz) {
  const struct {
    estimation::Model model;
    double stiffness;
  } rows[] = {{estimation::Model::friction, 5.10e6},
              {estimation::Model::friction_dashpot, 4.92e6},
              {estimation::Model::berg, 4.95e6}};
  for (const auto& row : rows) {
    const auto points = response::sweepConstantProduct(frictionModel(row.model), {20.0}, kProduct);
    EXPECT_NEAR(points[0].characteristics.stiffness, row.stiffness, 0.005e6) << estimation::toString(row.model);
  }
}

TEST(PaperNumbers, BergOverFrequencyAtConstantProduct) {
  const std::vector<double> frequencies = {0.5, 1, 2, 4, 8, 12, 20};
  const double stiffness[] = {3.28, 3.51, 3.84, 4.20, 4.55, 4.74, 4.95};
  const double angle[] = {4.88, 6.45, 6.72, 5.71, 4.29, 3.45, 2.51};
  const auto points = response::sweepConstantProduct(frictionModel(estimation::Model::berg), frequencies, kProduct);
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    EXPECT_NEAR(points[i].characteristics.stiffness, stiffness[i] * 1e6, 0.005e6) << frequencies[i];
    EXPECT_NEAR(points[i].characteristics.loss_angle * 180.0 / element::kPi, angle[i], 0.005) << frequencies[i];
  }
}

}  // namespace
}  // namespace rubber_suspension
