// A node with a bad configuration prints one line that names the mistake, and ends with exit status 1.
#include <gtest/gtest.h>
#include <ros/master.h>
#include <ros/ros.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "bench.h"
#include "ros_interface/child_process.h"

namespace rubber_suspension {
namespace {

constexpr const char* kNode = "bad_simulate";

struct Outcome {
  int status = -1;
  std::vector<std::string> lines;  // lines of stderr and stdout
};

// Runs the node until it ends, but at most for 20 s.
Outcome runNode(const std::string& arguments) {
  Outcome outcome;
  const std::string command =
      "timeout 20 " + ros_interface::siblingProgram("simulate") + " __name:=" + kNode + " " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) {
    outcome.lines.emplace_back(buffer.data());
  }
  const int status = pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

bool nodeIsLeft() {
  std::vector<std::string> nodes;
  ros::master::getNodes(nodes);
  return std::find(nodes.begin(), nodes.end(), std::string("/") + kNode) != nodes.end();
}

class BadConfig : public testing::Test {
 protected:
  void SetUp() override { ros::param::del(std::string("/") + kNode); }

  void expectRefusal(const std::string& arguments, const std::vector<std::string>& words) {
    const Outcome outcome = runNode(arguments);
    EXPECT_EQ(outcome.status, 1);
    ASSERT_EQ(outcome.lines.size(), 1U) << testing::PrintToString(outcome.lines);
    for (const std::string& word : words) {
      EXPECT_NE(outcome.lines[0].find(word), std::string::npos) << outcome.lines[0] << " should name " << word;
    }
    EXPECT_FALSE(nodeIsLeft());
  }

  std::string writeFile(const std::string& text) const {
    const std::string path = testing::TempDir() + "bad_config.yaml";
    std::ofstream(path) << text;
    return path;
  }

  std::string goodFile() const { return ros::NodeHandle("~").param<std::string>("good_file", ""); }
};

TEST_F(BadConfig, NeitherFileNorParameters) { expectRefusal("", {"config_file", "components", "exactly one"}); }

TEST_F(BadConfig, FileAndParameters) {
  ros::param::set(std::string("/") + kNode + "/components/a/model", "elements");
  expectRefusal("_config_file:=" + goodFile(), {"config_file", "components", "exactly one"});
}

TEST_F(BadConfig, MissingFile) { expectRefusal("_config_file:=/nowhere/bad.yaml", {"/nowhere/bad.yaml"}); }

TEST_F(BadConfig, UnknownKey) {
  const std::string path =
      writeFile("components:\n  left:\n    model: elements\n    elements:\n      - {type: spring, stifness: 3.0e6}\n");
  expectRefusal("_config_file:=" + path, {path, "left", "stifness", "stiffness"});
}

TEST_F(BadConfig, SpecificationWithoutSolution) {
  const std::string path = writeFile(
      "components:\n  left:\n    model: multi_maxwell\n    specification: {static_stiffness: 3.0e6, dynamic_stiffness: "
      "4.2e6, nominal_frequency: 4.0, maximum_stiffness: 4.9e6, high_frequency: 25.0, maxwell_elements: 2}\n");
  expectRefusal("_config_file:=" + path, {path, "left", "dynamic_stiffness"});
}

TEST_F(BadConfig, OddComponentName) {
  for (const std::string name : {"\"left secondary\"", "\"left/secondary\"", "\"1st\"", "\"l\\u00e4ngs\"", "\"\""}) {
    const std::string path = writeFile(
        "components:\n  " + name + ":\n    model: elements\n    elements:\n      - {type: spring, stiffness: 3e6}\n");
    expectRefusal("_config_file:=" + path, {path});
  }
}

TEST_F(BadConfig, BadParameters) {
  ros::param::set(std::string("/") + kNode + "/components/left/model", "elements");
  expectRefusal("", {"/bad_simulate/components", "left", "elements"});
}

TEST_F(BadConfig, UnknownSetting) {
  expectRefusal("_max_gapp:=1.0 _config_file:=" + goodFile(), {"max_gapp", "max_gap"});
}

TEST_F(BadConfig, SettingOutOfRange) {
  expectRefusal("_max_gap:=-1.0 _config_file:=" + goodFile(), {"max_gap", "-1", "greater than 0"});
}

TEST_F(BadConfig, WrongUsageEndsInStatusTwo) {
  const Outcome outcome = runNode("--no-such-option");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.lines.size(), 1U);
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "bad_config"); }
