// Two components in a node do not affect each other. Parameters on the server give the same forces as a file.
#include <cmath>

#include "bench.h"
#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension {
namespace {

double displacementOf(int component, int sample) {
  return 2e-3 * std::sin(0.02 * (component + 1) * sample) + 1e-4 * std::cos(0.7 * sample);
}

TEST(TwoComponents, EachGivesTheForcesThatItGivesAlone) {
  const auto descriptions = io::loadComponentFile(ros::NodeHandle("~").param<std::string>("config_file", ""));
  ASSERT_EQ(descriptions.size(), 2U);
  std::vector<std::unique_ptr<Bench>> benches;
  for (const auto& description : descriptions) {
    benches.push_back(std::make_unique<Bench>(description.name));
    ASSERT_TRUE(benches.back()->connect());
  }
  constexpr int kSamples = 3000;
  for (int i = 0; i < kSamples; ++i) {
    for (int c = 0; c < 2; ++c) {
      benches[static_cast<std::size_t>(c)]->send(kStart + i * kMillisecond, displacementOf(c, i));
    }
  }
  for (int c = 0; c < 2; ++c) {
    Bench& bench = *benches[static_cast<std::size_t>(c)];
    ASSERT_TRUE(bench.waitForForces(kSamples));
    const component::Component component = descriptions[static_cast<std::size_t>(c)].makeComponent();
    component::SampleStream alone(component);
    for (int i = 0; i < kSamples; ++i) {
      const Force& force = bench.forces[static_cast<std::size_t>(i)];
      ASSERT_EQ(force.force, alone.push(kStart + i * kMillisecond, displacementOf(c, i)).force.total)
          << descriptions[static_cast<std::size_t>(c)].name << ", sample " << i;
    }
    EXPECT_EQ(bench.forces.size(), static_cast<std::size_t>(kSamples));
  }
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "two_components"); }
