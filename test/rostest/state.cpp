// Tests the services that change states and parameters: reset, save, load, enable and reload.
#include <rubber_suspension/EnableComponent.h>
#include <rubber_suspension/ResetComponent.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "bench.h"

namespace rubber_suspension {
namespace {

constexpr const char* kStateFile = "/tmp/rubber_suspension_state_test.json";

double wave(int i) { return 2e-3 * std::sin(0.025 * i) + 1e-4 * std::cos(0.3 * i); }

std_srvs::Trigger::Response trigger(const std::string& service) {
  std_srvs::Trigger call;
  EXPECT_TRUE(ros_interface::callService(service, call)) << service;
  return call.response;
}

void enable(const std::string& service, bool enabled) {
  std_srvs::SetBool call;
  call.request.data = enabled ? 1 : 0;
  EXPECT_TRUE(ros_interface::callService(service, call)) << service;
  EXPECT_TRUE(call.response.success);
}

template <class Service>
void callFor(const std::string& service, const std::string& component, Service call) {
  call.request.component = component;
  EXPECT_TRUE(ros_interface::callService(service, call)) << service;
  EXPECT_TRUE(call.response.success) << call.response.message;
  call.request.component = component + "s";
  EXPECT_TRUE(ros_interface::callService(service, call)) << service;
  EXPECT_FALSE(call.response.success);
  EXPECT_NE(call.response.message.find("did you mean"), std::string::npos) << call.response.message;
}

void enableComponent(const std::string& component, bool enabled) {
  EnableComponent call;
  call.request.data = enabled ? 1 : 0;
  callFor("/simulate/enable_component", component, call);
}

void resetComponent(const std::string& component) { callFor("/simulate/reset_component", component, ResetComponent()); }

class State : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(bench_.connect());
    EXPECT_TRUE(trigger("/simulate/reset").success);
  }

  std::vector<double> forces(int first, int end) {
    std::vector<double> result;
    for (int i = first; i < end; ++i) {
      result.push_back(bench_.ask(kStart + i * kMillisecond, wave(i)).force);
    }
    return result;
  }

  Bench bench_{"right_secondary"};
};

TEST_F(State, LoadedGoesOnBitByBit) {
  forces(0, 500);
  ASSERT_TRUE(trigger("/simulate/save_state").success);
  const std::vector<double> without_interruption = forces(500, 1000);
  const auto loaded = trigger("/simulate/load_state");
  ASSERT_TRUE(loaded.success) << loaded.message;
  EXPECT_EQ(forces(500, 1000), without_interruption);
}

TEST_F(State, BadFileIsRefusedAndTheOldStateGoesOn) {
  const std::vector<double> whole = forces(0, 200);
  ASSERT_TRUE(trigger("/simulate/save_state").success);
  std::stringstream text;
  text << std::ifstream(kStateFile).rdbuf();
  std::string other = text.str();
  other.replace(other.find("left_secondary"), 14, "wrong_secondar");
  for (const std::string& bad :
       {std::string("{"), std::string("{}"), text.str().substr(0, text.str().size() / 2), other}) {
    std::ofstream(kStateFile) << bad;
    const auto answer = trigger("/simulate/load_state");
    EXPECT_FALSE(answer.success);
    EXPECT_FALSE(answer.message.empty());
  }
  std::remove(kStateFile);
  EXPECT_FALSE(trigger("/simulate/load_state").success);
  const std::vector<double> rest = forces(200, 300);
  trigger("/simulate/reset");
  EXPECT_EQ(forces(0, 200), whole);
  EXPECT_EQ(forces(200, 300), rest);
}

TEST_F(State, NeedsTheParameterThatNamesTheFile) {
  const auto answer = trigger("/other/without_file/save_state");
  EXPECT_FALSE(answer.success);
  EXPECT_NE(answer.message.find("state_file"), std::string::npos) << answer.message;
}

TEST_F(State, DisabledDropsAndKeepsItsState) {
  DiagnosticsWatch diagnostics;
  const std::vector<double> before = forces(0, 100);
  enableComponent("right_secondary", false);
  const std::size_t answered = bench_.forces.size();
  for (int i = 100; i < 110; ++i) {
    bench_.send(kStart + i * kMillisecond, 0.5);
  }
  EXPECT_TRUE(diagnostics.waitForCount("right_secondary", "dropped, disabled", 10));
  enable("/simulate/set_enabled", true);
  const std::vector<double> after = forces(110, 150);
  EXPECT_EQ(bench_.forces.size(), answered + 40);
  // Samples sent while the component is disabled have no effect on its state.
  resetComponent("right_secondary");
  forces(0, 100);
  EXPECT_EQ(forces(110, 150), after);
}

class Reload : public State {
 protected:
  void SetUp() override {
    State::SetUp();
    ASSERT_TRUE(ros::NodeHandle("~").getParam("components", original_));
  }
  void TearDown() override {
    ros::param::set("/simulate/components", original_);
    EXPECT_TRUE(trigger("/simulate/reload").success);
  }

  XmlRpc::XmlRpcValue original_;
};

TEST_F(Reload, UnchangedGoesOn) {
  forces(0, 100);
  const std::vector<double> expected = forces(100, 200);
  trigger("/simulate/reset");
  forces(0, 100);
  const auto answer = trigger("/simulate/reload");
  EXPECT_TRUE(answer.success) << answer.message;
  EXPECT_EQ(forces(100, 200), expected);
}

TEST_F(Reload, ChangedStartsAsNew) {
  forces(0, 100);
  ros::param::set("/simulate/components/right_secondary/specification/static_stiffness", 2.5e6);
  const auto answer = trigger("/simulate/reload");
  EXPECT_TRUE(answer.success) << answer.message;
  // The component is at rest at 2 mm, with the new static stiffness.
  EXPECT_NEAR(bench_.ask(kStart + 100 * kMillisecond, 0.002).force, 5000.0, 1e-6);
}

TEST_F(Reload, BadIsRefusedWholeAndTheOldModelGoesOn) {
  forces(0, 100);
  const std::vector<double> expected = forces(100, 200);
  trigger("/simulate/reset");
  forces(0, 100);
  // The parameters on the left are valid, those on the right are not, so neither component may change.
  ros::param::set("/simulate/components/left_secondary/specification/static_stiffness", 2.5e6);
  ros::param::set("/simulate/components/right_secondary/specification/static_stiffness", -1.0);
  const auto answer = trigger("/simulate/reload");
  EXPECT_FALSE(answer.success);
  EXPECT_NE(answer.message.find("static_stiffness"), std::string::npos) << answer.message;
  EXPECT_EQ(forces(100, 200), expected);
  Bench left("left_secondary");
  ASSERT_TRUE(left.connect());
  EXPECT_NEAR(left.ask(kStart, 0.002).force, 6000.0, 1e-6);
}

TEST_F(Reload, OtherComponentsAreRefused) {
  ros::param::del("/simulate/components/left_secondary");
  const auto answer = trigger("/simulate/reload");
  EXPECT_FALSE(answer.success);
  EXPECT_NE(answer.message.find("left_secondary"), std::string::npos) << answer.message;
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "state"); }
