// Tests the live diagnosis over topics. Friction that begins during the run is named with its onset. A service promotes
// the model, which closes the gap, and another service rolls back, which opens the gap again.
#include <rubber_suspension/Diagnosis.h>
#include <rubber_suspension/Gap.h>
#include <rubber_suspension/MeasuredForce.h>
#include <rubber_suspension/Running.h>
#include <std_srvs/Trigger.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <thread>

#include "bench.h"
#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension {
namespace {

constexpr int kRate = 200;       // [Hz]
constexpr double kOnset = 50.0;  // time after the start [s]

/// Simulates the component with white noise of 1 % of its force and, once switched on, friction.
class VirtualRig {
 public:
  explicit VirtualRig(const io::ComponentDescription& component)
      : friction_({{"friction", {{"maximum_force", {1200.0}}, {"displacement", {0.0003}}}}}),
        component_(component.makeComponent()),
        stream_(component_),
        friction_stream_(friction_) {}

  static double displacement(double t) {
    double sum = 0.0;
    for (int line = 1; line <= 12; ++line) {
      const double frequency = 0.37 * std::pow(1.3, line);
      sum += std::sin(2.0 * element::kPi * frequency * t + line * line) / frequency;
    }
    return 1.5e-3 * sum;
  }

  double force(std::int64_t stamp, double t) {
    const double z = displacement(t);
    const double ours = stream_.push(stamp, z).force.total;
    const double friction = friction_stream_.push(stamp, z).force.total;
    return ours + (t < kOnset ? 0.0 : friction) + 70.0 * noise_(random_);
  }

 private:
  component::Component friction_;
  component::Component component_;
  component::SampleStream stream_;
  component::SampleStream friction_stream_;
  std::mt19937 random_{1};
  std::normal_distribution<double> noise_;
};

class LiveDiagnosisTopic : public testing::Test {
 protected:
  void SetUp() override {
    std::string file;
    ASSERT_TRUE(ros::param::get("~config_file", file));
    rig_ = std::make_unique<VirtualRig>(io::loadComponentFile(file).front());
    measured_ = handle_.advertise<MeasuredForce>("bush/measured_force", 10000);
    listen<Diagnosis>("bush/diagnosis", diagnosis_);
    listen<Running>("bush/running", running_);
    listen<Gap>("bush/gap", gap_);
    listen<Gap>("bush/shadow_gap", shadow_gap_);
    ASSERT_TRUE(bench_.connect());
    ASSERT_TRUE(spinUntil([&] { return measured_.getNumSubscribers() > 0; }));
    // Both topics are latched, so their messages arrive without any sample.
    ASSERT_TRUE(spinUntil([&] { return !diagnosis_.verdict.empty() && !running_.component.empty(); }));
  }

  template <class Message>
  void listen(const std::string& topic, Message& newest) {
    subscribers_.push_back(handle_.subscribe<Message>(
        topic, 100, [&newest](const typename Message::ConstPtr& message) { newest = *message; }));
  }

  static std::int64_t stampOf(double t) { return kStart + std::llround(1e9 * t); }

  // Continues for a duration [s of the stamps] at twenty times real time, or until `done`. A batch is sent when the
  // previous one was answered, so that no sample is lost.
  void play(double duration, const std::function<bool()>& done = [] { return false; }) {
    const std::int64_t last = count_ + std::llround(duration * kRate);
    while (count_ < last && !done() && !HasFatalFailure()) {
      for (int i = 0; i < kRate / 10; ++i, ++count_) {
        const double t = static_cast<double>(count_) / kRate;
        bench_.send(stampOf(t), VirtualRig::displacement(t));
        MeasuredForce message;
        message.header.stamp = bag::toRosTime(stampOf(t));
        message.force = rig_->force(stampOf(t), t);
        measured_.publish(message);
      }
      ASSERT_TRUE(bench_.waitForForces(static_cast<std::size_t>(count_)));
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      ros::getGlobalCallbackQueue()->callAvailable();
    }
  }

  double now() const { return static_cast<double>(count_) / kRate; }

  // Returns the mean gap over the next windows, as published by the node.
  double gapFromNow() {
    play(6.0);  // longer than a window, so that the window contains no earlier samples
    const ros::Time fresh = bag::toRosTime(stampOf(now()));
    play(60.0, [&] { return gap_.header.stamp > fresh; });
    EXPECT_GT(gap_.header.stamp, fresh);
    return gap_.gap;
  }

  static std_srvs::Trigger call(const std::string& service) {
    std_srvs::Trigger trigger;
    EXPECT_TRUE(ros::service::waitForService(service, ros::Duration(kPatience)));
    EXPECT_TRUE(ros_interface::callService(service, trigger));
    return trigger;
  }

  ros::NodeHandle handle_;
  Bench bench_{"bush"};
  std::unique_ptr<VirtualRig> rig_;
  ros::Publisher measured_;
  std::vector<ros::Subscriber> subscribers_;
  Diagnosis diagnosis_;
  Running running_;
  Gap gap_;
  Gap shadow_gap_;
  std::int64_t count_ = 0;  // number of samples sent
};

TEST_F(LiveDiagnosisTopic, NamesTheFrictionPromotesItAndGoesBack) {
  EXPECT_EQ(diagnosis_.verdict, "watching");
  EXPECT_EQ(running_.stage, Running::CONFIGURED);
  const auto early = call("bush/promote");
  EXPECT_FALSE(early.response.success);
  EXPECT_NE(early.response.message.find("there is no model to promote"), std::string::npos) << early.response.message;
  EXPECT_FALSE(call("bush/rollback").response.success);

  play(kOnset, [&] { return !diagnosis_.effects.empty(); });
  EXPECT_TRUE(diagnosis_.effects.empty()) << diagnosis_.sentence;
  // A gtest checks the limit of two minutes. Here the diagnosis may take longer, if other programs slow it down.
  play(600.0, [&] { return !diagnosis_.effects.empty(); });
  ASSERT_FALSE(diagnosis_.effects.empty()) << diagnosis_.verdict << ": " << diagnosis_.sentence;
  EXPECT_EQ(diagnosis_.effects.front(), "friction") << diagnosis_.sentence;
  ASSERT_TRUE(diagnosis_.since_known);
  EXPECT_NEAR((diagnosis_.since - bag::toRosTime(kStart)).toSec(), kOnset, 10.0);
  EXPECT_GE(diagnosis_.evidence, diagnosis_.evidence_needed);
  EXPECT_LT(diagnosis_.gap_augmented, 0.5 * diagnosis_.gap_as_configured);

  const double before = gapFromNow();
  const auto promote = call("bush/promote");
  ASSERT_TRUE(promote.response.success) << promote.response.message;
  const std::string configured = running_.sha256;
  play(60.0, [&] { return running_.stage == Running::PROMOTED; });
  ASSERT_EQ(running_.stage, Running::PROMOTED) << running_.note;
  EXPECT_EQ(running_.other_sha256, configured);
  EXPECT_NE(running_.sha256, configured);
  EXPECT_FALSE(running_.added.empty());
  const double promoted = gapFromNow();
  EXPECT_LT(promoted, 0.5 * before);  // the noise of 1 % is an eighth of the gap due to the friction
  // The gap of the configured model is still published. It differs somewhat, because the motion differs.
  EXPECT_NEAR(shadow_gap_.gap, before, 0.3 * before);

  ASSERT_TRUE(call("bush/rollback").response.success);
  play(60.0, [&] { return running_.stage == Running::CONFIGURED; });
  EXPECT_EQ(running_.sha256, configured);
  EXPECT_NEAR(gapFromNow(), before, 0.3 * before);
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "live_diagnosis"); }
