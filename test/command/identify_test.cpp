// `estimate --from-log` makes a component file from a log.
#include "command/identify.h"

#include <nlohmann/json.hpp>

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/replay.h"
#include "support/kit.h"
#include "support/scratch_folder.h"

namespace rubber_suspension {
namespace {

const char* const kFile = R"(
components:
  left:
    model: multi_maxwell
    specification: {static_stiffness: 3 MN/m, dynamic_stiffness: 4.2e6, nominal_frequency: 4, maximum_stiffness: 4.9e6,
                    high_frequency: 25, maxwell_elements: 3}
)";

io::ComponentDescription description() { return componentOf(kFile); }

// Returns the log of a component that is a fifth stiffer than its specification.
log::Log measuredLog() {
  log::Log log = logOf("sweep", 2000, 5000000, [](int i) {
    const double t = i * 0.005;
    return 1e-3 * std::sin(2.0 * element::kPi * (0.2 + 0.5 * t) * t);
  });
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

// A reversed channel and a force in tonnes must be refused, although they could be fitted.
TEST(IdentifyFromLogs, RefusesAReversedChannelAndAUnitThatIsOffByThousands) {
  for (const auto& [factor, reason] :
       {std::pair(-1.0, "the sign of one channel is reversed"), {1.0 / 9806.65, "N and tonnes"}}) {
    log::Log log = measuredLog();
    for (double& force : log.force) {
      force *= factor;
    }
    const std::string message = messageOf<log::LogError>([&] { command::identifyFromLogs(description(), {log}, {}); });
    EXPECT_THAT(message, HasSubstr(std::string("sweep: ")));
    EXPECT_THAT(message, HasSubstr(reason));
  }
}

// Returns the stiffness of the spring if the file is read with the option that a refusal advises.
double springOf(const std::string& path, const log::LogFormat& format) {
  return command::identifyFromLogs(description(), {log::readLog(path, format)}, {}).elements[0].value("stiffness");
}

std::string refusalOf(const std::string& path) {
  return messageOf<log::LogError>([&] { springOf(path, {}); });
}

log::LogFormat withColumns(const std::string& assignment) { return log::makeLogFormat({assignment}, "", 0.0); }

// Writes a file of a log whose force is multiplied, although its header states newtons.
class AdviceOfTheBench : public ::testing::Test {
 protected:
  void write(double factor) {
    log::Log log = measuredLog();
    for (double& force : log.force) {
      force *= factor;
    }
    log::writeLogCsv(file_.path(), log);
  }

  TemporaryFile file_{"log.csv", ""};
  const double spring_ = 1.2 * description().allElements()[0].value("stiffness");
};

TEST_F(AdviceOfTheBench, TurnsASign) {
  write(-1.0);
  EXPECT_THAT(refusalOf(file_.path()), HasSubstr("--columns force=-NAME"));
  EXPECT_NEAR(springOf(file_.path(), withColumns("force=-force_N")), spring_, 1e-4 * spring_);
}

TEST_F(AdviceOfTheBench, NamesScalesOrAcceptsAUnit) {
  write(1e-3);
  const std::string advice = refusalOf(file_.path());
  EXPECT_THAT(advice, HasSubstr("--unit force=kN"));
  EXPECT_NEAR(springOf(file_.path(), log::makeLogFormat({}, "force=kN", 0.0)), spring_, 1e-4 * spring_);
  EXPECT_THAT(advice, HasSubstr("--columns force=1000*NAME or displacement=0.001*NAME"));
  EXPECT_NEAR(springOf(file_.path(), withColumns("force=1000*force_N")), spring_, 1e-4 * spring_);
  EXPECT_NEAR(springOf(file_.path(), withColumns("displacement=0.001*displacement_m")), spring_, 1e-4 * spring_);
  EXPECT_THAT(advice, HasSubstr("--accept-units"));
  log::LogFormat accepted;
  accepted.accept_units = true;
  EXPECT_NEAR(springOf(file_.path(), accepted), 1e-3 * spring_, 1e-7 * spring_);
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
  EXPECT_THAT(text, HasSubstr("keep the values of the specification"));
  const auto json = nlohmann::json::parse(command::toJson("left", result));
  EXPECT_EQ(json["schema"], "rubber_suspension/identification/1");
  ASSERT_EQ(json["parameters"].size(), result.parameters.size());
  EXPECT_EQ(json["parameters"][1]["value"], result.parameters[1].value);
  EXPECT_EQ(json["parameters"][1]["interval_95"][1], result.parameters[1].upper);
  EXPECT_EQ(command::identificationFigure(description(), result, {measuredLog()}).axes.size(), 2u);
}

// Returns a log that starts in motion, with an offset of the force, noise and a spike.
log::Log benchLog(const std::string& name, unsigned seed, double zero) {
  constexpr int kBefore = 900;
  constexpr int kSamples = 3000;
  constexpr double kNoise = 5.0;
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, kNoise);
  const log::Log all = logOf("all", kBefore + kSamples, 5000000, [&](int i) {
    const double t = i * 0.005;
    return 1e-3 * std::sin(2.0 * element::kPi * (2.0 + 0.1 * seed) * t) +
           1e-3 * std::sin(2.0 * element::kPi * 0.31 * t + seed);
  });
  const std::vector<double> force = gap::simulateLog(description().makeComponent(), all);
  log::Log log = logOf(
      name, kSamples, 5000000, [&](int i) { return all.displacement[static_cast<std::size_t>(kBefore + i)]; },
      [&](int i, double /*z*/) {
        return 1.2 * force[static_cast<std::size_t>(kBefore + i)] + zero + normal(generator);
      });
  log.force[1500] += 9000.0;
  return log;
}

// Returns the largest error of the ratio of a parameter to its given value. The true ratio is 1.2.
double worstRatio(const fit::Identification& result) {
  double worst = 0.0;
  for (const fit::IdentifiedParameter& parameter : result.parameters) {
    worst = std::max(worst, std::abs(parameter.value / parameter.given - 1.2));
  }
  return worst;
}

TEST(IdentifyFromLogs, TakesOutWhatTheRigDid) {
  const std::vector<log::Log> logs = {benchLog("one", 1, 400.0), benchLog("two", 2, -700.0)};
  fit::IdentificationOptions held;
  held.held = {"maxwell.break_frequency"};
  const double without = worstRatio(fit::identify(description().allElements(), logs, held));
  const fit::Identification result = command::identifyFromLogs(description(), logs, {});
  // The corrections reduce the error to less than a tenth. The rest is noise, which the intervals cover.
  EXPECT_LT(worstRatio(result), 0.1 * without);
  int outside = 0;
  for (const fit::IdentifiedParameter& parameter : result.parameters) {
    const double truth = 1.2 * parameter.given;
    outside += truth < parameter.lower || truth > parameter.upper ? 1 : 0;
  }
  EXPECT_EQ(outside, 0);
  EXPECT_THAT(result.notes, testing::Contains(HasSubstr("spike")));
  EXPECT_THAT(result.notes, testing::Contains(HasSubstr("zero")));
}

TEST(IdentifyFromLogs, LeavesLogsWithoutFaultsAsTheyAre) {
  const fit::Identification result = command::identifyFromLogs(description(), {measuredLog(), measuredLog()}, {});
  EXPECT_LT(worstRatio(result), 1e-6);
  EXPECT_THAT(result.notes, testing::SizeIs(1)) << "of the break frequencies";
}

TEST(IdentifyFromLogs, NeedsAForce) {
  log::Log log = measuredLog();
  log.force.clear();
  EXPECT_THROW(command::identifyFromLogs(description(), {log}, {}), log::LogError);
}

}  // namespace
}  // namespace rubber_suspension
