// The report of `estimate --from-log`: from a log back to a component file.
#include "command/identify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/replay.h"

namespace rubber_suspension {
namespace {

using ::testing::HasSubstr;

const char* const kFile = R"(
components:
  left:
    model: multi_maxwell
    specification: {static_stiffness: 3 MN/m, dynamic_stiffness: 4.2e6, nominal_frequency: 4, maximum_stiffness: 4.9e6,
                    high_frequency: 25, maxwell_elements: 3}
)";

io::ComponentDescription description() { return io::parseComponentFile(kFile, "test").at(0); }

// A specimen that is a fifth stiffer than specified.
log::Log measuredLog() {
  log::Log log;
  log.name = "sweep";
  for (int i = 0; i < 2000; ++i) {
    const double t = i * 0.005;
    log.stamp.push_back(static_cast<std::int64_t>(i) * 5000000);
    log.displacement.push_back(1e-3 * std::sin(2.0 * element::kPi * (0.2 + 0.5 * t) * t));
  }
  log.force = gap::simulateLog(description().makeComponent(), log);
  for (double& force : log.force) {
    force *= 1.2;
  }
  return log;
}

TEST(IdentifyFromLogs, FindsTheStiffnessesAndKeepsTheBreakFrequencies) {
  const auto given = description().allElements();
  const fit::Identification result = command::identifyFromLogs(description(), {measuredLog()}, {});
  ASSERT_EQ(result.elements.size(), given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    EXPECT_NEAR(result.elements[i].value("stiffness") / given[i].value("stiffness"), 1.2, 1e-6);
    if (i > 0) {
      EXPECT_EQ(result.elements[i].value("break_frequency"), given[i].value("break_frequency"));
    }
  }
}

TEST(IdentifyFromLogs, ComponentWithTheValuesFoundReproducesTheLog) {
  const log::Log log = measuredLog();
  const auto component =
      command::identifiedComponent(description(), command::identifyFromLogs(description(), {log}, {}));
  const auto read_back = io::parseComponentFile(io::toYaml({component}), "written");
  EXPECT_LT(gap::relativeGap(log.force, gap::simulateLog(read_back.at(0).makeComponent(), log)), 1e-6);
}

TEST(IdentifyFromLogs, ReportsInTextAndJson) {
  const fit::Identification result = command::identifyFromLogs(description(), {measuredLog()}, {});
  const std::string text = command::toText("left", result);
  EXPECT_THAT(text, HasSubstr("95 % interval"));
  EXPECT_THAT(text, HasSubstr("kept as estimated"));
  const auto json = nlohmann::json::parse(command::toJson("left", result));
  EXPECT_EQ(json["schema"], "rubber_suspension/identification/1");
  ASSERT_EQ(json["parameters"].size(), result.parameters.size());
  EXPECT_EQ(json["parameters"][1]["value"], result.parameters[1].value);
  EXPECT_EQ(json["parameters"][1]["interval_95"][1], result.parameters[1].upper);
  EXPECT_EQ(command::identificationFigure(description(), result, {measuredLog()}).axes.size(), 2u);
}

TEST(IdentifyFromLogs, NeedsAForce) {
  log::Log log = measuredLog();
  log.force.clear();
  EXPECT_THROW(command::identifyFromLogs(description(), {log}, {}), log::LogError);
}

}  // namespace
}  // namespace rubber_suspension
