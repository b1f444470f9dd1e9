// Tests a diagnosis in the running system: on a held-out log, the node with the augmented component file shows the gap
// that the report states.
#include <cmath>
#include <filesystem>
#include <memory>

#include "../diagnosis/rig.h"
#include "bench.h"
#include "ros_interface/child_process.h"
#include "ros_interface/log_player.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension {
namespace {

// Returns smooth dry friction after Dahl, in parallel with the force of the rig. No candidate has this law.
RigEffect dahlFriction() {
  auto force = std::make_shared<double>(0.0);
  auto last = std::make_shared<double>(0.0);
  return [=](double time, double z, double /*rate*/) {
    if (time == 0.0) {
      *force = 0.0;
      *last = z;
    }
    const double way = z - *last;
    *force += 1.5e6 * way * (1.0 - *force / 200.0 * (way > 0.0 ? 1.0 : -1.0));
    *last = z;
    return *force;
  };
}

double gapOf(const log::Log& log, const std::vector<element::ComponentForce>& simulated) {
  double mean = 0.0;
  for (const double force : log.force) {
    mean += force / static_cast<double>(log.size());
  }
  double squared = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    squared += std::pow(log.force[i] - simulated[i].total, 2);
    variance += std::pow(log.force[i] - mean, 2);
  }
  return std::sqrt(squared / variance);
}

TEST(AugmentedGap, IsWhatTheReportClaims) {
  const log::Log unseen = runRig("unseen", 3, dahlFriction());
  const diagnosis::Diagnosis result = diagnosis::diagnose(
      rigComponent(), {runRig("one", 1, dahlFriction()), runRig("two", 2, dahlFriction())}, {unseen});
  ASSERT_FALSE(result.answer.effects.empty()) << result.sentence;
  EXPECT_EQ(result.answer.effects.front(), "friction");
  EXPECT_LT(result.gaps.unseen.augmented, 0.5 * result.gaps.unseen.re_estimated);

  const std::string folder = testing::TempDir() + "augmented_gap";
  diagnosis::writeReport(result, folder);
  const ros_interface::ChildProcess node(
      {ros_interface::siblingProgram("simulate"), "_config_file:=" + folder + "/augmented.yaml"});
  ros_interface::PlayOptions options;
  options.component = result.component;
  ros_interface::LogPlayer player(ros::NodeHandle(), options);
  const ros_interface::PlayResult played = player.play(unseen);
  ASSERT_TRUE(played.exactlyOneEach());
  // Both gaps are computed by the same code from the same numbers, up to the order of summation.
  EXPECT_NEAR(gapOf(unseen, played.force), result.gap_as_recorded.augmented, 1e-9);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "augmented_gap"); }
