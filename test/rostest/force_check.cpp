// Tests the test node check_force with a running node: when it passes, when it fails, and its report in XML.
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <cstdlib>
#include <random>

#include "bench.h"
#include "ros_interface/child_process.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension {
namespace {

constexpr double kNoise = 0.1;  // standard deviation of the noise divided by that of the measured force

// Exit status of the program, number of failures, and text of the first failure.
struct Outcome {
  int status = -1;
  int failures = -1;
  std::string message;
};

class ForceCheckNode : public testing::Test {
 protected:
  std::string config() const { return ros::NodeHandle("~").param<std::string>("config_file", ""); }
  std::string path(const std::string& end) const { return testing::TempDir() + "force_check" + end; }

  Outcome run(const std::string& arguments) const {
    const std::string report = path(".xml");
    std::remove(report.c_str());
    const std::string command = ros_interface::siblingProgram("check_force") +
                                " __name:=check_force_inner --reset /simulate/reset " + arguments +
                                " --gtest_output=xml:" + report;
    Outcome outcome;
    const int status = std::system(command.c_str());
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    try {
      boost::property_tree::ptree tree;
      boost::property_tree::read_xml(report, tree);
      outcome.failures = tree.get<int>("testsuites.testsuite.<xmlattr>.failures");
      for (const auto& [tag, test] : tree.get_child("testsuites.testsuite")) {
        if (tag == "testcase") {
          outcome.message += test.get<std::string>("failure", "");
        }
      }
    } catch (const boost::property_tree::ptree_error& error) {
      outcome.message = error.what();
    }
    return outcome;
  }

  // Writes the force of left_secondary with white noise of a tenth of its standard deviation, with a fixed seed.
  void writeMeasured() const {
    log::Log log;
    log.name = "measured";
    for (int i = 0; i < 4000; ++i) {
      log.stamp.push_back(kStart + i * kMillisecond);
      log.displacement.push_back(2e-3 * std::sin(0.02 * i) + 5e-4 * std::cos(0.11 * i));
    }
    log.force =
        gap::simulateLog(io::selectComponent(io::loadComponentFile(config()), "left_secondary").makeComponent(), log);
    double square = 0.0;
    for (const double force : log.force) {
      square += force * force;
    }
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, kNoise * std::sqrt(square / static_cast<double>(log.size())));
    for (double& force : log.force) {
      force += noise(random);
    }
    log::writeLogCsv(path(".csv"), log);
  }
};

// The standard deviation of 4000 noise samples has a standard error of 1/sqrt(8000) = 1.1 %, so both limits are ten
// standard errors away. The mean of the force changes the gap by less than 1 %.
TEST_F(ForceCheckNode, PassesAndFailsOnEitherSideOfTheGap) {
  writeMeasured();
  const std::string log = "--component left_secondary --log " + path(".csv");
  const Outcome passed = run(log + " --tolerance 0.112");
  EXPECT_EQ(passed.status, 0) << passed.message;
  EXPECT_EQ(passed.failures, 0);
  const Outcome failed = run(log + " --tolerance 0.088");
  EXPECT_EQ(failed.status, 1);
  EXPECT_EQ(failed.failures, 1);
  EXPECT_NE(failed.message.find("beyond the limit 0.088"), std::string::npos) << failed.message;
}

TEST_F(ForceCheckNode, NoticesAnotherComponentThanExpected) {
  writeMeasured();
  const Outcome outcome =
      run("--component left_secondary --config-component right_secondary --tolerance 1e-3 --config " + config() +
          " --log " + path(".csv"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.failures, 1);
}

TEST_F(ForceCheckNode, FailsWithAReportWhereNoBenchAnswers) {
  writeMeasured();
  const Outcome outcome = run("--component nobody --connect-timeout 0.3 --tolerance 1 --log " + path(".csv"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.failures, 1);
  EXPECT_NE(outcome.message.find("no node serves /nobody/displacement"), std::string::npos) << outcome.message;
}

TEST_F(ForceCheckNode, FailsWithAReportWhereTheLogCannotBeUsed) {
  const Outcome outcome = run("--component left_secondary --tolerance 1 --log /nowhere.csv");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.failures, 1);
  EXPECT_NE(outcome.message.find("/nowhere.csv"), std::string::npos) << outcome.message;
}

TEST_F(ForceCheckNode, RefusesWrongUsage) {
  EXPECT_EQ(run("--component left_secondary --log x.csv").status, 2);
  EXPECT_EQ(run("--component left_secondary --log x.csv --tolerance nan").status, 2);
  EXPECT_EQ(run("--component left_secondary --log x.csv --tolerance -1").status, 2);
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "force_check"); }
