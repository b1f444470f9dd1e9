// Stiffness and loss angle of the whole component, before and after augmentation.
#include "diagnosis/results/characteristics.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

// Returns a sine of 5 Hz and 2 mm.
log::Record sine() {
  log::Record record;
  record.dt = 1e-3;
  record.mean_frequency = 5.0;
  record.displacement = Eigen::VectorXd::LinSpaced(1000, 0.0, 1.0).unaryExpr([](double t) {
    return 2e-3 * std::sin(31.4159265358979 * t);
  });
  return record;
}

// Heating for hours would reduce the stiffness to a fifth. The 20 cycles of the test reduce it by 0.16 %: a sensitivity
// of 1e-4 1/J times a work of 4 * 100 N * 2 mm per cycle.
TEST(WholeStiffness, IsToldBeforeTheComponentHasWarmed) {
  io::ComponentDescription before("bush", {spring(1e6), friction(100.0, 1e-5)});
  io::ComponentDescription after = before;
  after.add = {{"self_heating", {{"energy_sensitivity", {1e-4}}, {"time_constant", {1e5}}}}};
  const auto whole = diagnosis::results::wholeStiffness(before, after, {sine()});
  ASSERT_TRUE(whole.has_value());
  EXPECT_EQ(whole->frequency, 5.0);
  EXPECT_NEAR(whole->amplitude, 2e-3, 1e-5);
  EXPECT_LT(whole->stiffness[1], whole->stiffness[0]);
  EXPECT_GT(whole->stiffness[1], 0.998 * whole->stiffness[0]);
}

TEST(WholeStiffness, IsThatOfTheRubber) {
  const io::ComponentDescription before("bush", {spring(1e6)});
  io::ComponentDescription after = before;
  after.add = {{"time_delay", {{"delay", {1e-3}}}}, {"inertia", {{"mass", {100.0}}}, true}};
  const auto whole = diagnosis::results::wholeStiffness(before, after, {sine()});
  ASSERT_TRUE(whole.has_value());
  EXPECT_EQ(whole->stiffness[1], whole->stiffness[0]);
  EXPECT_EQ(whole->loss_angle[1], whole->loss_angle[0]);
}

}  // namespace
}  // namespace rubber_suspension
