// The report of `estimate`: the numbers of the sweeps in text and JSON.
#include "command/estimate.h"

#include <nlohmann/json.hpp>

#include "support/test.h"

namespace rubber_suspension {
namespace {

const char* const kFile = R"(
components:
  left:
    model: multi_maxwell
    specification: {static_stiffness: 3 MN/m, dynamic_stiffness: 4.2e6, nominal_frequency: 4, maximum_stiffness: 4.9e6,
                    high_frequency: 25}
  right:
    model: friction
    specification: {static_stiffness: 3 MN/m, dynamic_stiffness: 4.2e6, nominal_frequency: 4, nominal_amplitude: 2 mm,
                    relative_damping: 5 %}
  plain:
    model: elements
    elements: [{type: spring, stiffness: 1e6}]
)";

std::vector<io::ComponentDescription> components() { return io::parseComponentFile(kFile, "test"); }

command::EstimateReport reportOf(const std::string& name, const command::SweepOptions& options = {}) {
  return command::makeEstimateReport(io::selectComponent(components(), name), options);
}

TEST(EstimateReport, SweepsFollowFromTheSpecification) {
  const command::EstimateReport report = reportOf("right");
  EXPECT_FALSE(report.linear);
  EXPECT_EQ(report.working_point.frequency, 4.0);
  EXPECT_EQ(report.working_point.amplitude, 2e-3);
  EXPECT_NEAR(report.working_point.characteristics.stiffness, 4.2e6, 4.2);
  EXPECT_NEAR(report.product, 8e-3, 1e-15);
  EXPECT_EQ(report.over_frequency.size(), 13u);
  EXPECT_NEAR(report.over_frequency.front().frequency, 0.4, 1e-12);
  EXPECT_EQ(reportOf("left").over_frequency.back().frequency, 25.0);
  EXPECT_TRUE(reportOf("plain").linear);
}

TEST(EstimateReport, SweepsFollowTheOptions) {
  command::SweepOptions options;
  options.lowest_frequency = 1.0;
  options.highest_frequency = 2.0;
  options.lowest_amplitude = 1e-4;
  options.highest_amplitude = 3e-4;
  options.frequency = 5.0;
  options.amplitude = 1e-3;
  options.product = 2e-3;
  options.points = 3;
  const command::EstimateReport report = reportOf("right", options);
  EXPECT_EQ(report.over_frequency.size(), 3u);
  EXPECT_EQ(report.over_frequency.back().frequency, 2.0);
  EXPECT_EQ(report.over_frequency.back().amplitude, 1e-3);
  EXPECT_EQ(report.over_amplitude.front().amplitude, 1e-4);
  EXPECT_EQ(report.over_amplitude.front().frequency, 5.0);
  EXPECT_EQ(report.over_product.back().amplitude, 1e-3);
}

TEST(EstimateReport, RefusesRangesThatAreNone) {
  command::SweepOptions options;
  options.lowest_frequency = 100.0;
  EXPECT_THROW(reportOf("left", options), std::invalid_argument);
  options = {};
  options.points = 1;
  EXPECT_THROW(reportOf("left", options), std::invalid_argument);
}

TEST(EstimateReport, JsonHasEveryNumber) {
  const command::EstimateReport report = reportOf("right");
  const auto json = nlohmann::json::parse(command::toJson({reportOf("left"), report}));
  EXPECT_EQ(json["schema"], "rubber_suspension/estimate/1");
  ASSERT_EQ(json["components"].size(), 2u);
  const auto& right = json["components"][1];
  EXPECT_EQ(right["component"], "right");
  EXPECT_EQ(right["model"], "friction");
  EXPECT_EQ(right["specification"]["nominal_amplitude"], 2e-3);
  EXPECT_EQ(right["elements"][1]["type"], "friction");
  EXPECT_EQ(right["elements"][1]["maximum_force"], report.elements[1].value("maximum_force"));
  EXPECT_EQ(right["over_amplitude"].size(), report.over_amplitude.size());
  EXPECT_EQ(right["over_amplitude"][3]["stiffness_n_per_m"], report.over_amplitude[3].characteristics.stiffness);
  EXPECT_EQ(right["over_frequency"][3]["loss_angle_rad"], report.over_frequency[3].characteristics.loss_angle);
  EXPECT_EQ(right["at_constant_product"][3]["amplitude_m"], report.over_product[3].amplitude);
}

TEST(EstimateReport, TextNamesUnitsAndReconstruction) {
  const std::string text = command::toText(reportOf("left"));
  EXPECT_THAT(text, HasSubstr("stiffness 233442 N/m, break_frequency 0.0348316 Hz"));
  EXPECT_THAT(text, HasSubstr("reconstruction"));
  EXPECT_THAT(text, HasSubstr("K [N/m]"));
  EXPECT_THAT(command::toText(reportOf("right")), HasSubstr("dead_band"));
}

TEST(EstimateReport, FigureHasACurvePerComponent) {
  const io::Figure figure = command::toFigure({reportOf("left"), reportOf("right")});
  ASSERT_EQ(figure.axes.size(), 6u);
  for (const io::Axes& axes : figure.axes) {
    ASSERT_GE(axes.curves.size(), 2u);
    EXPECT_EQ(axes.curves[0].label, "left");
    EXPECT_EQ(axes.curves[1].label, "right");
  }
}

// The figure marks the specified values, and the curves pass through these marks.
TEST(EstimateReport, FigureMarksTheSpecification) {
  const command::EstimateReport report = reportOf("left");
  const io::Figure figure = command::toFigure({report});
  const io::Axes& stiffness = figure.axes.at(0);
  EXPECT_EQ(stiffness.title, fmt::format("constant amplitude {:.4g} mm", 1e3 * report.working_point.amplitude));
  const auto curve = [&](const std::string& label) {
    const auto found = std::find_if(stiffness.curves.begin(), stiffness.curves.end(),
                                    [&](const io::Curve& other) { return other.label == label; });
    return found == stiffness.curves.end() ? io::Curve{} : *found;
  };
  const estimation::Specification& specified = report.description.specification();
  EXPECT_THAT(curve("K_st").y, testing::Each(specified.at("static_stiffness") * 1e-6));
  EXPECT_THAT(curve("K_max").y, testing::Each(specified.at("maximum_stiffness") * 1e-6));
  EXPECT_THAT(curve("K_n at f_n").x, testing::ElementsAre(specified.at("nominal_frequency")));
  EXPECT_THAT(curve("K_n at f_n").y, testing::ElementsAre(specified.at("dynamic_stiffness") * 1e-6));
  EXPECT_TRUE(curve("K at f_h").x.empty());  // K_max is not the stiffness at the frequency f_h
}

}  // namespace
}  // namespace rubber_suspension
