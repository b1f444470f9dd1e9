// Fits of parameters to a table of stiffness and loss angle.
#include "fit/table_fit.h"

#include "rubber_suspension/fit/identification.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/response/sweep.h"
#include "support/kit.h"

namespace rubber_suspension::fit {
namespace {

io::ComponentDescription bush(double stiffness, double maxwell, double break_frequency, double friction,
                              double displacement) {
  return {"bush",
          {{"spring", {{"stiffness", {stiffness}}}},
           {"maxwell", {{"stiffness", {maxwell}}, {"break_frequency", {break_frequency}}}},
           {"friction", {{"maximum_force", {friction}}, {"displacement", {displacement}}}}}};
}

io::ComponentDescription truth() { return bush(3e6, 1e6, 2.0, 5e3, 2.2e-3); }
io::ComponentDescription guess() { return bush(2.4e6, 1.7e6, 3.5, 3e3, 1.2e-3); }

std::vector<TablePoint> tableOf(const io::ComponentDescription& description) {
  const component::Component component = description.makeComponent();
  std::vector<TablePoint> points;
  for (const double amplitude : {1e-4, 4e-4, 1e-3, 4e-3}) {
    for (const double frequency : {0.25, 1.0, 4.0, 16.0}) {
      const auto loop = response::characteristicsAt(component, frequency, amplitude).characteristics;
      points.push_back({frequency, amplitude, loop.stiffness, loop.loss_angle});
    }
  }
  return points;
}

const FittedParameter& parameterOf(const TableFit& fit, const std::string& name) {
  const auto found = std::find_if(fit.parameters.begin(), fit.parameters.end(),
                                  [&](const FittedParameter& parameter) { return parameter.name == name; });
  EXPECT_NE(found, fit.parameters.end()) << name;
  return *found;
}

TEST(TableFit, FindsTheParametersThatMadeTheTable) {
  const TableFit fit = fitToTable(guess(), tableOf(truth()));
  EXPECT_GT(fit.misfit_before, 0.05);
  // The table uses four times as many samples per cycle as the fit, which changes loop areas by 2e-4.
  EXPECT_LT(fit.misfit, 1e-3);
  const std::vector<std::pair<std::string, double>> expected = {{"spring[0].stiffness", 3e6},
                                                                {"maxwell[1].stiffness", 1e6},
                                                                {"maxwell[1].break_frequency", 2.0},
                                                                {"friction[2].maximum_force", 5e3},
                                                                {"friction[2].displacement", 2.2e-3}};
  ASSERT_EQ(fit.parameters.size(), expected.size());
  for (const auto& [name, value] : expected) {
    const FittedParameter& parameter = parameterOf(fit, name);
    EXPECT_NEAR(parameter.value, value, 1e-2 * value) << name;
    EXPECT_TRUE(parameter.determined) << name;
  }
  EXPECT_EQ(fit.component.elements().size(), 3U);
}

// Fits to a table and to a log of the same component give the same elements.
TEST(TableFit, AgreesWithTheFitToALog) {
  log::Log log = logOf("sines", 20000, 1000000, [](int i) {
    const double time = 1e-3 * i;
    return 2e-3 * std::sin(3.0 * time) + 5e-4 * std::sin(31.0 * time) + 1e-4 * std::sin(200.0 * time);
  });
  log.force = gap::simulateLog(truth().makeComponent(), log);
  IdentificationOptions options;
  options.starts = 2;
  options.held = {"friction.dead_band"};
  const Identification identified = identify(guess().elements(), {log}, options);
  const TableFit fit = fitToTable(guess(), tableOf(truth()));
  for (const IdentifiedParameter& parameter : identified.parameters) {
    const std::string name = parameter.element + "[" + std::to_string(parameter.index) + "]." + parameter.name;
    EXPECT_NEAR(parameterOf(fit, name).value, parameter.value, 2e-2 * parameter.value) << name;
  }
  EXPECT_EQ(identified.parameters.size(), fit.parameters.size());
}

TEST(TableFit, TellsWhatTheTableDoesNotShow) {
  std::vector<TablePoint> points;
  const component::Component component = truth().makeComponent();
  for (const double frequency : {40.0, 80.0}) {
    const auto loop = response::characteristicsAt(component, frequency, 1e-3).characteristics;
    points.push_back({frequency, 1e-3, loop.stiffness, loop.loss_angle});
  }
  const TableFit fit = fitToTable(guess(), points);
  // Two points at one amplitude, far above the break frequency, determine four of the five parameters.
  EXPECT_TRUE(std::any_of(fit.parameters.begin(), fit.parameters.end(),
                          [](const FittedParameter& parameter) { return !parameter.determined; }));
}

TEST(TableFit, RefusesWhatIsNoTable) {
  const auto refuses = [](const std::vector<TablePoint>& points, const char* reason) {
    EXPECT_THAT([&] { fitToTable(guess(), points); }, testing::ThrowsMessage<std::invalid_argument>(HasSubstr(reason)));
  };
  refuses({}, "0 points");
  refuses({{1.0, 1e-3, 3e6, 0.1}}, "1 points");
  refuses({{1.0, 1e-3, 3e6, 0.1}, {0.0, 1e-3, 3e6, 0.1}}, "0 Hz");
  refuses({{1.0, 1e-3, 3e6, 0.1}, {1.0, 1e-3, 3e6, 2.0}}, "2 rad");
  EXPECT_THROW(
      fitToTable(io::ComponentDescription("none", {entry("spring_table displacement=-1e-3,1e-3 force=-1e3,1e3")}),
                 tableOf(truth())),
      std::invalid_argument);
}

// A stiffening spring is stiffer about a preload, so rows with mean displacements separate its linear and cubic part.
TEST(TableFit, FollowsRowsAboutAMeanDisplacement) {
  const auto stiffening = [](double stiffness, double cubic) {
    return io::ComponentDescription{
        "bush",
        {{"spring", {{"stiffness", {stiffness}}}}, {"progressive_stiffness", {{"cubic", {cubic}}}}, maxwell(4e5, 2.0)}};
  };
  const component::Component truth = stiffening(3e6, 1e11).makeComponent();
  std::vector<TablePoint> points;
  for (const double mean : {0.0, 2e-3, -4e-3}) {
    for (const double frequency : {1.0, 4.0}) {
      response::LoopOptions options;
      options.mean = mean;
      const auto loop = response::characteristicsAt(truth, frequency, 2e-4, options).characteristics;
      points.push_back({frequency, 2e-4, loop.stiffness, loop.loss_angle, mean});
    }
  }
  const TableFit fit = fitToTable(stiffening(2e6, 3e11), points);
  // The table uses four times as many samples per cycle as the fit, which changes loop areas by 2e-4.
  EXPECT_LT(fit.misfit, 1e-3);
  EXPECT_NEAR(parameterOf(fit, "spring[0].stiffness").value, 3e6, 1e-2 * 3e6);
  EXPECT_NEAR(parameterOf(fit, "progressive_stiffness[1].cubic").value, 1e11, 1e-2 * 1e11);
}

}  // namespace
}  // namespace rubber_suspension::fit
